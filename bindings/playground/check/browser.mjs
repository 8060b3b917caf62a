// Controls a headless browser through its debugging pipe.
import { spawn } from "node:child_process";
import { mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

export class Browser {
  constructor(program) {
    const home = mkdtempSync(join(tmpdir(), "playground-"));
    const flags = ["--headless=new", "--remote-debugging-pipe", `--user-data-dir=${home}`, "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars", "about:blank"];
    this.process = spawn(program, flags, { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.asked = new Map();
    this.listeners = [];
    this.last = 0;
    let rest = "";
    this.process.stdio[4].on("data", (data) => {
      const texts = (rest + data).split("\0");
      rest = texts.pop();
      texts.forEach((text) => this.told(JSON.parse(text)));
    });
  }

  told(message) {
    const asked = this.asked.get(message.id);
    if (asked) {
      this.asked.delete(message.id);
      if (message.error) asked.fail(new Error(message.error.message));
      else asked.done(message.result);
    } else this.listeners.forEach((listen) => listen(message));
  }

  send(method, params = {}, session = this.session) {
    const id = ++this.last;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: session })}\0`);
    return new Promise((done, fail) => this.asked.set(id, { done, fail }));
  }

  // Opens a page and collects its console messages, errors and requests.
  async open(url, { width = 1280, height = 1000, dark = false, phone = false } = {}) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" }, undefined);
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true }, undefined);
    this.session = sessionId;
    const page = { messages: [], requests: [], url };
    this.listeners = [({ method, params }) => {
      if (method === "Runtime.consoleAPICalled") page.messages.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
      if (method === "Runtime.exceptionThrown") page.messages.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
      if (method === "Log.entryAdded") page.messages.push(`${params.entry.source}: ${params.entry.text}`);
      if (method === "Network.requestWillBeSent" && !/^(blob|data):/.test(params.request.url)) page.requests.push(params.request.url);
    }];
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await this.send(`${domain}.enable`);
    await this.send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: phone ? 2 : 1, mobile: phone });
    await this.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: dark ? "dark" : "light" }] });
    await this.send("Page.navigate", { url });
    return page;
  }

  // Evaluates an expression in the page.
  async run(expression) {
    const found = await this.send("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (found.exceptionDetails) throw new Error(found.exceptionDetails.exception?.description ?? found.exceptionDetails.text);
    return found.result.value;
  }

  // Waits until an expression is true in the page.
  async until(expression, seconds = 20) {
    const end = Date.now() + 1000 * seconds;
    while (Date.now() < end) {
      try { if (await this.run(expression)) return; } catch { /* The page is not there yet. */ }
      await new Promise((done) => setTimeout(done, 50));
    }
    throw new Error(`after ${seconds} s this is still not true: ${expression}`);
  }

  async screenshot() {
    const { contentSize } = await this.send("Page.getLayoutMetrics").then((metrics) => ({ contentSize: metrics.cssContentSize }));
    const clip = { x: 0, y: 0, width: contentSize.width, height: contentSize.height, scale: 1 };
    const { data } = await this.send("Page.captureScreenshot", { clip, captureBeyondViewport: true });
    return Buffer.from(data, "base64");
  }

  close() {
    this.process.kill();
  }
}
