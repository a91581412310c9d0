// The built page in a real browser: served on loopback, watched for errors.

import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { type Browser, chromium, type Page } from "playwright-core";
import { type PreviewServer, preview } from "vite";
import { onTestFailed, onTestFinished } from "vitest";

const root = fileURLToPath(new URL("../..", import.meta.url));

const flags = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Milliseconds that anything may take to come, the browser itself, too: nothing here is a test of speed. */
const PATIENCE = 120_000;

/** What the page's workers have been asked and have not answered yet; kept by `listen`. */
type Open = Map<Worker, Set<string>>;

/** Runs in the page before all else: listens to what its workers are asked, and to their answers. */
function listen(): void {
  const open: Open = new Map();
  Object.assign(globalThis, { open });
  // Those may still be asked something, by whoever has waited for the module, and never answer.
  const dead = new WeakSet<Worker>();
  const { postMessage, terminate } = Worker.prototype;
  Worker.prototype.postMessage = function (this: Worker, message: { id?: string }, ...more: unknown[]) {
    const mine = open.get(this) ?? new Set();
    if (!open.has(this)) this.addEventListener("message", ({ data }) => mine.delete(data.id));
    open.set(this, mine);
    if (message.id && !dead.has(this)) mine.add(message.id);
    Reflect.apply(postMessage, this, [message, ...more]);
  };
  Worker.prototype.terminate = function (this: Worker) {
    open.delete(this);
    dead.add(this);
    Reflect.apply(terminate, this, []);
  };
}

/**
 * Waits until the page has nothing more to do, however slow the machine is: no question to a worker is open, and for
 * some frames in a row nothing has come of what has been done. Not for a page that plays.
 */
export const settled = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    const { open } = globalThis as unknown as { open: Open };
    const isBusy = () =>
      !document.querySelector(".app[data-ready=true]") || [...open.values()].some(({ size }) => size > 0);
    // Effects come a frame and a timer later than what they follow, and may have effects themselves.
    for (let calm = 0; calm < 4; calm++) {
      await new Promise((next) => setTimeout(next));
      await new Promise(requestAnimationFrame);
      if (isBusy()) calm = -1;
    }
  });

/** The page, served, and a browser to open it in. */
export class Theatre {
  /** What the console or an uncaught exception has complained about. */
  readonly complaints: string[] = [];

  private constructor(
    readonly address: string,
    private readonly server: PreviewServer,
    private readonly browser: Browser,
  ) {}

  /** Serves `dist/` and starts a browser; CHROMIUM names another one. */
  static async open(more: string[] = []): Promise<Theatre> {
    if (!existsSync(`${root}/dist/index.html`)) throw new Error("no page is built: npm run build");
    const server = await preview({
      root,
      preview: { host: "127.0.0.1", port: 0, open: false },
      logLevel: "error",
    });
    const address = server.resolvedUrls?.local[0];
    if (!address) throw new Error("the server has no address");
    const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
    const browser = await chromium.launch({
      executablePath,
      args: [...flags, ...more],
      timeout: PATIENCE,
    });
    return new Theatre(address, server, browser);
  }

  /** Opens the page anew; `hash` is a deep link, or a whole address of another page; `options` are those of Playwright's contexts; `before` prepares it. */
  async visit(
    hash = "",
    options: Parameters<Browser["newContext"]>[0] = {},
    before: (page: Page) => Promise<unknown> = async () => {},
  ): Promise<Page> {
    const context = await this.browser.newContext({ locale: "en", ...options });
    context.setDefaultTimeout(PATIENCE);
    // What a test leaves open would be at work beside the next one, and what it has complained about is its own.
    onTestFinished(() => context.close());
    onTestFailed(() => void this.complaints.splice(0));
    await context.addInitScript(listen);
    const page = await context.newPage();
    await before(page);
    return this.watch(page, hash);
  }

  private async watch(page: Page, hash: string): Promise<Page> {
    page.on("console", (message) => {
      // Reading a canvas back, as taking a screenshot does, is slow without a graphics processor; Chromium says so.
      if (message.text().includes("GPU stall due to ReadPixels")) return;
      if (["error", "warning"].includes(message.type())) this.complaints.push(message.text());
    });
    page.on("pageerror", (error) => this.complaints.push(String(error)));
    await page.goto(new URL(hash, this.address).href);
    return page;
  }

  async close(): Promise<void> {
    await this.browser.close();
    await this.server.close();
  }
}
