// Makes the page work without a network from the next visit on: a service worker keeps its files. Not for
// `delone theatre`, which serves at 127.0.0.1 and is to leave nothing behind in the browser.

/** Tells whether a page at this address keeps itself. */
export function keepsItself({ protocol, hostname }: Pick<Location, "protocol" | "hostname">): boolean {
  return protocol === "https:" || hostname === "localhost";
}

export function beOffline(): void {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator) || !keepsItself(location)) return;
  // Whoever forbids it has a page that needs the network, and no worse one.
  navigator.serviceWorker.register("./sw.js").catch(() => {});
}
