// Loads the program and the level, then plays in real time, or by script.js. Options, in the page's address:
//     ?size=320x240   pixels of the image      ?preset=fast   quality      ?script=1   the script; serve.py starts it
"use strict";

const options = new URLSearchParams(location.search);
const canvas = document.getElementById("canvas");
const statusLine = document.getElementById("status");

/** Tells the server of a script's run something: a name, and text or an image. */
function report(name, body) {
    return fetch(`report/${name}`, {method: "POST", body});
}

const lines = [];
/** A line of the program. */
function say(text) {
    console.log(text);
    lines.push(text);
}

async function fetchBytes(url) {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: the server answered ${response.status}`);
    return new Uint8Array(await response.arrayBuffer());
}

/** The program with the level, whose memory is the program's from then on. */
async function begin() {
    const [width, height] = (options.get("size") || "640x360").split("x").map(Number);
    if (!(width > 0 && height > 0)) throw new Error(`size: expected WIDTHxHEIGHT, found ${options.get("size")}`);
    canvas.width = width;
    canvas.height = height;
    const [host, level] = await Promise.all([createHost({print: say, printErr: say}), fetchBytes("town.rubble")]);
    const address = host._malloc(level.length);
    host.HEAPU8.set(level, address);
    host._host_begin(address, level.length);
    if (options.has("preset")) setQuality(host, options.get("preset"), true);
    return host;
}

/** Draws with a preset, with the host's own triangles or without. */
function setQuality(host, preset, withMeshes) {
    host.ccall("host_quality", null, ["string", "number"], [preset, Number(withMeshes)]);
}

/** Plays in real time: as many steps of 1/60 s as have passed, at most four a frame. Frames of the last second go to
 *  `shown`. It ends when `isOver()` says so. */
function play(host, shown, isOver = () => false) {
    let last = performance.now(), waiting = 0, frames = 0, since = last;
    return new Promise(resolve => {
        const frame = now => {
            waiting = Math.min(waiting + (now - last) * 0.06, 4);
            last = now;
            const steps = Math.floor(waiting);
            waiting -= steps;
            host._host_step(steps);
            host._host_draw(waiting);
            ++frames;
            if (now - since >= 1000) {
                shown(frames * 1000 / (now - since));
                frames = 0;
                since = now;
            }
            if (isOver()) resolve();
            else requestAnimationFrame(frame);
        };
        requestAnimationFrame(frame);
    });
}

begin().then(async host => {
    statusLine.textContent = "";
    if (options.has("script")) return playScript(host);
    return play(host, rate => statusLine.textContent = `${rate.toFixed(0)} frames/s`);
}).catch(error => {
    statusLine.textContent = `${error}`;
    if (options.has("script")) report("failed", `${lines.join("\n")}\n${error.stack || error}`);
});
