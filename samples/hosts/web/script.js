// What is played where no player does: the events that a player's hands make, images after them, a context that is lost,
// and, if the address asks for it (?speed=SECONDS), frames a second with each of ?presets=A,B. serve.py collects what it reports.
"use strict";

const kFrames = 16;  // of an image: light gathers over some frames
const kCycle = 300;  // steps until the level is loaded again

/** Writes an image and the line of it. */
async function takeImage(host, name) {
    host.ccall("host_image", null, ["string", "number"], [name, kFrames]);
    const image = await new Promise(resolve => canvas.toBlob(resolve, "image/png"));
    await report(name, image);
}

function click() {
    canvas.dispatchEvent(new MouseEvent("mousedown", {bubbles: true, button: 0}));
}

function press(code) {
    for (const type of ["keydown", "keyup"]) window.dispatchEvent(new KeyboardEvent(type, {code, bubbles: true}));
}

/** A hole by a click, an explosion by a key, and what comes of it. imageOf: called with the name of each image. */
async function playCycle(host, imageOf) {
    host._host_step(2);
    await imageOf("1_start");
    click();
    host._host_step(10);
    await imageOf("2_hole");
    press("KeyE");
    host._host_step(15);
    await imageOf("3_flying");
    host._host_step(kCycle - 27);
    await imageOf("4_end");
    host._host_memory();
}

function eventOf(target, name) {
    return new Promise(resolve => target.addEventListener(name, resolve, {once: true}));
}

/** Loses the context, as a reset of the driver does, and gets it back. */
async function loseContext() {
    const extension = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const lost = eventOf(canvas, "webglcontextlost"), restored = eventOf(canvas, "webglcontextrestored");
    extension.loseContext();
    await lost;
    await new Promise(resolve => setTimeout(resolve));
    extension.restoreContext();
    await restored;
}

/** The median of the frames a second in real time, with each preset. */
async function measure(host, seconds) {
    for (const preset of (options.get("presets") || "balanced,draft").split(",")) {
        for (const withMeshes of [true, false]) {
            setQuality(host, preset, withMeshes);
            const rates = [];
            await play(host, rate => rates.push(rate), () => rates.length >= seconds + 2);
            const counted = rates.slice(2).sort((a, b) => a - b);  // programs are compiled in the first
            const rate = counted[counted.length >> 1].toFixed(1);
            say(`${preset} at ${canvas.width}x${canvas.height}, ${withMeshes ? "with" : "without"} own triangles: ` +
                `${rate} frames/s`);
        }
    }
}

async function playScript(host) {
    if (!options.has("skip")) {
        await playCycle(host, name => takeImage(host, name));
        await loseContext();
        await takeImage(host, "5_restored");
    }
    if (options.has("speed")) await measure(host, Number(options.get("speed")));
    for (let i = 1; i < Number(options.get("cycles") || 1); ++i) {
        press("KeyR");
        await playCycle(host, () => host._host_draw(1.0));
    }
    await report("end", lines.join("\n"));
}
