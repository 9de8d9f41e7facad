// The panel, the legend and the keys.

const element = (id) => document.getElementById(id);

function listItems(texts) {
  return texts.map((text) => {
    const item = document.createElement("li");
    item.textContent = text;
    return item;
  });
}

// Initial values may follow the file's name: #angle=90&opacity=0.5&colour=Lambda
function settingsOf(hash) {
  return Object.fromEntries(new URLSearchParams(hash.replace(/^#/, "")));
}

function describeCount(shown, mesh) {
  const number = (n) => n.toLocaleString("en");
  const parts = Object.entries(shown)
    .filter(([kind]) => mesh[kind].count > 0)
    .map(([kind, n]) =>
      `${number(n)} of ${number(mesh[kind].count)} ${kind === "vertices" ? "points" : kind}`);
  return parts.join(", ") || "the axis is empty";
}

function showLegend(array, colours) {
  element("legend").hidden = array.values.length === 0;
  const stops = colours.map(([share, ...rgb]) =>
    `rgb(${rgb.map((c) => Math.round(255 * c)).join(" ")}) ${100 * share}%`);
  element("legend-bar").style.background = `linear-gradient(to top, ${stops.join(", ")})`;
  element("legend-title").textContent = `${array.label} (${array.unit})`;
  const items = listItems(array.ticks.map(([, text]) => text));
  items.forEach((item, i) => { item.style.bottom = `${100 * array.ticks[i][0] / array.max}%`; });
  element("legend-labels").replaceChildren(...items);
}

function fillPanel(page, scene) {
  document.title = `Medial axis of ${page.title}`;
  element("title").textContent = page.title;
  element("settings").textContent = page.settings.join(", ");
  element("notes").replaceChildren(...listItems(page.notes));
  element("about").open = page.simplified;
  element("flat").hidden = !page.flat;
  element("show").hidden = !scene.hasSkeleton;
  element("show-label").hidden = !scene.hasSkeleton;
  element("colour").replaceChildren(...scene.axisMesh.arrays.map((array) => {
    const option = document.createElement("option");
    option.value = array.name;
    option.textContent = array.label;
    return option;
  }));
}

// Each control by the function that applies its value.
function makeAppliers(page, scene) {
  const arrays = scene.axisMesh.arrays;
  return {
    // At its lower end all cells are shown: facets leave some points below the angle of the axis.
    angle() {
      const angle = Number(element("angle").value);
      const shown = scene.setAngle(angle > Number(element("angle").min) ? angle : 0);
      element("angle-value").textContent = `${angle}\u00b0`;
      element("count").textContent = describeCount(shown, scene.axisMesh);
    },
    show() {
      scene.show(element("show").value);
    },
    opacity() {
      scene.setOpacity(Number(element("opacity").value));
    },
    colour() {
      const array = arrays.find(({ name }) => name === element("colour").value);
      scene.setColour(array, page.colours);
      showLegend(array, page.colours);
    },
  };
}

function setInitialValues(page, scene) {
  const angles = scene.axisMesh.arrays.find(({ name }) => name === "SeparationAngle");
  element("angle").min = Math.floor(Math.max(angles.origin, page.angle));
  const initial = { angle: element("angle").min, opacity: 0.15, colour: "Radius",
    show: scene.hasSkeleton ? "skeleton" : "axis" };
  const settings = settingsOf(location.hash);
  for (const id of Object.keys(initial)) {
    const given = Object.hasOwn(settings, id)
      && (element(id).matches("select") || Number.isFinite(Number(settings[id])));
    element(id).value = (given ? settings : initial)[id];
  }
  for (const id of ["colour", "show"]) {
    if (element(id).selectedIndex < 0 || (id === "show" && !scene.hasSkeleton)) {
      element(id).value = initial[id];
    }
  }
}

function change(id, value) {
  element(id).value = value;
  element(id).dispatchEvent(new Event("input"));
}

function next(id) {
  const list = element(id);
  change(id, list.options[(list.selectedIndex + 1) % list.options.length].value);
}

// Whether the key moves a slider or the list that has the focus.
function movesFocused(event) {
  return event.target instanceof HTMLElement && event.target.matches("input, select") &&
    event.key.startsWith("Arrow") && !event.shiftKey;
}

function listenToKeys() {
  let opacity = 0.2; // before the surface was switched off
  const turnAngle = (event, sign) =>
    change("angle", Number(element("angle").value) + sign * (event.shiftKey ? 10 : 1));
  const actions = {
    ArrowLeft: (event) => turnAngle(event, -1),
    ArrowRight: (event) => turnAngle(event, 1),
    s: () => {
      const now = Number(element("opacity").value);
      opacity = now || opacity;
      change("opacity", now > 0 ? 0 : opacity);
    },
    c: () => next("colour"),
    k: () => {
      if (!element("show").hidden) {
        next("show");
      }
    },
    r: () => element("reset").click(),
    e: () => element("edge").click(),
    h: () => { element("help").open = !element("help").open; },
  };
  // vtk.js has keys of its own, for wireframes and the like.
  window.addEventListener("keypress", (event) => event.stopImmediatePropagation(), true);
  window.addEventListener("keydown", (event) => {
    const action = actions[event.key] || actions[event.key.toLowerCase()];
    if (action && !movesFocused(event) && !event.ctrlKey && !event.altKey && !event.metaKey) {
      event.preventDefault();
      action(event);
    }
  });
}

function start() {
  const page = JSON.parse(element("data").textContent);
  listenToKeys();
  const scene = makeScene(element("view"), page);
  fillPanel(page, scene);
  setInitialValues(page, scene);
  const appliers = makeAppliers(page, scene);
  for (const [id, apply] of Object.entries(appliers)) {
    apply();
    element(id).addEventListener("input", () => {
      apply();
      scene.draw();
    });
  }
  for (const [id, turn] of [["reset", scene.resetView], ["edge", scene.turnToEdge]]) {
    element(id).addEventListener("click", () => {
      turn();
      scene.draw();
    });
  }
  element("reset").click();
  document.body.dataset.drawn = "yes";
}

function hasWebGl() {
  return document.createElement("canvas").getContext("webgl2") !== null;
}

try {
  start();
} catch (error) {
  const need = hasWebGl() ? "" : " It needs WebGL 2.";
  element("failure").textContent = `The page cannot be shown: ${error.message}.${need}`;
  element("failure").hidden = false;
}
