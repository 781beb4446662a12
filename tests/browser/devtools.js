/* Headless Chromium over the DevTools protocol, through the pipe that --remote-debugging-pipe
 * opens: no port, no driver package.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";
const { spawn } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

const FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
  "--hide-scrollbars", "--force-color-profile=srgb", "--remote-debugging-pipe"];
const ANSWER_MS = 60000;
const PICTURE_HEIGHT = 12000; /* px; the browser draws no more than 16384 */

class Browser {
  /* Starts the program with a profile of its own. */
  constructor(program) {
    this.profile = fs.mkdtempSync(path.join(os.tmpdir(), "touchstone-browser-"));
    this.child = spawn(program, [...FLAGS, `--user-data-dir=${this.profile}`, "about:blank"],
      { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
    this.waiting = new Map();
    this.listeners = [];
    this.next = 1;
    this.rest = "";
    this.ended = new Promise((resolve) => {
      this.child.on("exit", resolve);
      this.child.on("error", resolve); /* it was never started */
    });
    this.child.on("exit", () => this.fail(new Error("the browser ended")));
    this.child.on("error", (error) => this.fail(error));
    this.child.stdio[3].on("error", () => {}); /* reported by exit */
    this.child.stdio[4].setEncoding("utf8");
    this.child.stdio[4].on("data", (text) => this.take(text));
  }

  take(text) {
    const parts = (this.rest + text).split("\0");
    this.rest = parts.pop();
    for (const part of parts) {
      const message = JSON.parse(part);
      const waiting = this.waiting.get(message.id);
      if (waiting === undefined) {
        this.listeners.forEach((listener) => listener(message));
        continue;
      }
      this.waiting.delete(message.id);
      clearTimeout(waiting.timer);
      if (message.error) waiting.reject(new Error(`${waiting.method}: ${message.error.message}`));
      else waiting.resolve(message.result);
    }
  }

  fail(error) {
    this.waiting.forEach(({ reject, timer }) => { clearTimeout(timer); reject(error); });
    this.waiting.clear();
  }

  send(method, params = {}, sessionId = undefined) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      const timer = setTimeout(() => {
        this.waiting.delete(id);
        reject(new Error(`${method}: no answer in ${ANSWER_MS / 1000} s`));
      }, ANSWER_MS);
      this.waiting.set(id, { resolve, reject, timer, method });
      this.child.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
    });
  }

  async tab() {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    const tab = new Tab(this, sessionId);
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await tab.send(`${domain}.enable`);
    return tab;
  }

  async close() {
    this.send("Browser.close").catch(() => {});
    const timer = setTimeout(() => this.child.kill("SIGKILL"), 5000);
    await this.ended;
    clearTimeout(timer);
    fs.rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

/* Messages of the console, the network and the page itself. */
const COMPLAINTS = {
  "Runtime.exceptionThrown": ({ exceptionDetails: d }) =>
    `exception: ${(d.exception && d.exception.description) || d.text}`,
  "Runtime.consoleAPICalled": ({ type, args }) =>
    type === "error" || type === "assert" ? `console: ${args.map((a) => a.value).join(" ")}` : null,
  "Log.entryAdded": ({ entry }) => entry.level === "error" ? `log: ${entry.text} ${entry.url || ""}` : null,
  "Network.loadingFailed": ({ errorText }) => `not loaded: ${errorText}`,
  "Network.requestWillBeSent": ({ request }) =>
    /^(file|data|blob|about):/.test(request.url) ? null : `goes to the network: ${request.url}`,
};

class Tab {
  constructor(browser, sessionId) {
    this.browser = browser;
    this.session = sessionId;
    this.complaints = [];
    this.loaded = () => {};
    browser.listeners.push((message) => {
      if (message.sessionId !== sessionId) return;
      if (message.method === "Page.loadEventFired") this.loaded();
      const words = COMPLAINTS[message.method];
      const complaint = words ? words(message.params) : null;
      if (complaint) this.complaints.push(complaint);
    });
  }

  send(method, params) { return this.browser.send(method, params, this.session); }

  async open(url) {
    this.complaints = [];
    let timer;
    const loaded = new Promise((resolve, reject) => {
      this.loaded = resolve;
      timer = setTimeout(() => reject(new Error(`${url}: not loaded in ${ANSWER_MS / 1000} s`)), ANSWER_MS);
    });
    loaded.catch(() => {}); /* reported by the await below, unless the navigation failed before */
    try {
      const { errorText } = await this.send("Page.navigate", { url });
      if (errorText) throw new Error(`${url}: ${errorText}`);
      await loaded;
    } finally {
      clearTimeout(timer);
    }
  }

  /* The value of an expression in the page, awaited. */
  async ask(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails)
      throw new Error((exceptionDetails.exception && exceptionDetails.exception.description) ||
        exceptionDetails.text);
    return result.value;
  }

  /* Never as a mobile device: there the page widens with what sticks out of it, unseen. */
  width(width, height = 900) {
    return this.send("Emulation.setDeviceMetricsOverride",
      { width, height, deviceScaleFactor: 1, mobile: false });
  }

  scheme(value) {
    return this.send("Emulation.setEmulatedMedia",
      { features: [{ name: "prefers-color-scheme", value }] });
  }

  async key(key, code) {
    const text = key === "Enter" ? "\r" : undefined;
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", key, code: key, text, windowsVirtualKeyCode: code });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key, code: key, windowsVirtualKeyCode: code });
  }

  /* Of the whole page, from its top to its end. */
  async picture(file) {
    const { cssContentSize: { width, height } } = await this.send("Page.getLayoutMetrics");
    const clip = { x: 0, y: 0, width, height: Math.min(height, PICTURE_HEIGHT), scale: 1 };
    const { data } = await this.send("Page.captureScreenshot", { format: "png", clip, captureBeyondViewport: true });
    fs.writeFileSync(file, Buffer.from(data, "base64"));
  }
}

module.exports = { Browser };
