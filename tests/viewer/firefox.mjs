// SPDX-License-Identifier: Apache-2.0
// Drives Debian's Firefox by its own protocol, Marionette: messages "length:[kind, number, command or error, parameters or result]" on a
// local port. Without a display Firefox has no WebGL, so that it gets one of Xvfb's.

import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";

export const kFirefox = process.env.CROSSGRAIN_FIREFOX ?? "/usr/bin/firefox-esr";
const kDisplay = "/usr/bin/Xvfb";
export const has_firefox = () => existsSync(kFirefox) && existsSync(kDisplay);

// WebGL by software, which Firefox else refuses where there is no graphics card.
const kPreferences = {
  "webgl.force-enabled": true, "webgl.disabled": false, "gfx.x11-egl.force-enabled": true, "marionette.port": 0,
  "browser.shell.checkDefaultBrowser": false, "datareporting.policy.dataSubmissionEnabled": false, "toolkit.telemetry.reportingpolicy.firstRun": false,
  "app.update.enabled": false, "browser.startup.page": 0,
};
const kLongestStart = 60_000;

export class Firefox {
  profile = mkdtempSync(join(tmpdir(), "crossgrain-firefox-"));
  pending = new Map();
  received = Buffer.alloc(0);
  number = 0;

  /** A browser on a display of its own; throws if it does not start within a minute. */
  static async start() {
    const browser = new Firefox();
    const preferences = Object.entries(kPreferences).map(([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});`);
    writeFileSync(join(browser.profile, "user.js"), preferences.join("\n"));
    browser.display = spawn(kDisplay, ["-displayfd", "1", "-screen", "0", "1600x1000x24", "-nolisten", "tcp"], { stdio: ["ignore", "pipe", "ignore"] });
    const display = await new Promise((resolve, reject) => {
      browser.display.stdout.once("data", (bytes) => resolve(`:${String(bytes).trim()}`));
      browser.display.once("exit", () => reject(new Error("Xvfb did not start")));
    });
    browser.process = spawn(kFirefox, ["--no-remote", "--marionette", "--profile", browser.profile, "about:blank"], {
      stdio: "ignore", env: { ...process.env, DISPLAY: display, LIBGL_ALWAYS_SOFTWARE: "1", MOZ_DISABLE_CONTENT_SANDBOX: "1", HOME: browser.profile },
    });
    await browser.connected();
    await browser.send("WebDriver:NewSession", { capabilities: { alwaysMatch: { acceptInsecureCerts: true } } });
    await browser.send("WebDriver:SetTimeouts", { script: kLongestStart, pageLoad: kLongestStart });
    return browser;
  }

  async connected() {
    const port_file = join(this.profile, "MarionetteActivePort");
    const end = Date.now() + kLongestStart;
    while (!existsSync(port_file) || readFileSync(port_file, "utf8").trim() === "") {
      if (Date.now() > end || this.process.exitCode !== null) throw new Error("Firefox did not start");
      await pause(100);
    }
    this.socket = connect(Number(readFileSync(port_file, "utf8")), "127.0.0.1");
    await new Promise((resolve, reject) => {
      this.greeted = resolve;
      this.socket.on("error", reject);
      this.socket.on("data", (bytes) => this.take(bytes));
    });
  }

  take(bytes) {
    this.received = Buffer.concat([this.received, bytes]);
    for (;;) {
      const colon = this.received.indexOf(":");
      if (colon < 0) return;
      const length = Number(this.received.subarray(0, colon));
      if (this.received.length < colon + 1 + length) return;
      const message = JSON.parse(this.received.subarray(colon + 1, colon + 1 + length).toString("utf8"));
      this.received = this.received.subarray(colon + 1 + length);
      // The first message is a greeting, the others are answers: [1, number, error, result].
      if (!Array.isArray(message)) this.greeted();
      else {
        const { resolve, reject } = this.pending.get(message[1]);
        this.pending.delete(message[1]);
        if (message[2]) reject(new Error(message[2].message));
        else resolve(message[3]);
      }
    }
  }

  send(command, parameters = {}) {
    const text = JSON.stringify([0, ++this.number, command, parameters]);
    return new Promise((resolve, reject) => {
      this.pending.set(this.number, { resolve, reject });
      this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
  }

  open(address) {
    return this.send("WebDriver:Navigate", { url: address });
  }

  /** The value of the promise that an expression in the page gives. */
  async evaluate(expression) {
    const script = `const done = arguments[arguments.length - 1]; Promise.resolve().then(() => (${expression})).then((value) => done({ value }), (error) => done({ error: String(error) }));`;
    const { value } = await this.send("WebDriver:ExecuteAsyncScript", { script, args: [], newSandbox: false, sandbox: null });
    if (value.error) throw new Error(value.error);
    return value.value;
  }

  /** The window as a PNG in base64. */
  async screenshot() {
    return (await this.send("WebDriver:TakeScreenshot", { full: false })).value;
  }

  async close() {
    const ended = new Promise((resolve) => this.process.on("exit", resolve));
    await Promise.race([this.send("Marionette:Quit", { flags: ["eForceQuit"] }).catch(() => {}), pause(5000)]);
    this.socket?.destroy();
    if (this.process.exitCode === null) this.process.kill();
    await Promise.race([ended, pause(5000)]);
    this.display.kill();
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5 });
  }
}
