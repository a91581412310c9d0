// The built page in a real browser: served on loopback, watched for errors.

import { existsSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { type Browser, chromium, type Page } from "playwright-core";
import { type PreviewServer, preview } from "vite";

const root = fileURLToPath(new URL("../..", import.meta.url));

const flags = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
];

/** Milliseconds that anything may take to come: nothing here is a test of speed. */
const PATIENCE = 60_000;

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
    const browser = await chromium.launch({ executablePath, args: [...flags, ...more] });
    return new Theatre(address, server, browser);
  }

  /** Opens the page anew; `hash` is a deep link, `options` are those of Playwright's contexts; `before` prepares it. */
  async visit(
    hash = "",
    options: Parameters<Browser["newContext"]>[0] = {},
    before: (page: Page) => Promise<unknown> = async () => {},
  ): Promise<Page> {
    const context = await this.browser.newContext({ locale: "en", ...options });
    context.setDefaultTimeout(PATIENCE);
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
    await page.goto(this.address + hash);
    return page;
  }

  async close(): Promise<void> {
    await this.browser.close();
    await this.server.close();
  }
}
