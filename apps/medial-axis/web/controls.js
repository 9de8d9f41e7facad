// The panel, the legend and the keys.

const element = (id) => document.getElementById(id);

// Initial values may follow the file's name: #angle=90&opacity=0.5&colour=Lambda
function settingsOf(hash) {
  return Object.fromEntries(new URLSearchParams(hash.replace(/^#/, "")));
}

function describeCount(shown, mesh) {
  const number = (n) => n.toLocaleString("en");
  const parts = Object.entries(shown)
    .filter(([kind]) => mesh[kind].count > 0)
    .map(([kind, n]) => `${number(n)} of ${number(mesh[kind].count)} ${kind}`);
  return parts.join(", ") || "the axis is empty";
}

function showLegend(array, colours) {
  const stops = colours.map(([share, ...rgb]) =>
    `rgb(${rgb.map((c) => Math.round(255 * c)).join(" ")}) ${100 * share}%`);
  element("legend-bar").style.background = `linear-gradient(to top, ${stops.join(", ")})`;
  element("legend-title").textContent = `${array.label} (${array.unit})`;
  const labels = [1, 0.75, 0.5, 0.25, 0].map((share) => {
    const item = document.createElement("li");
    item.textContent = String(Number((array.origin + share * 65535 * array.step).toPrecision(3)));
    return item;
  });
  element("legend-labels").replaceChildren(...labels);
}

function fillPanel(page, scene) {
  document.title = `Medial axis of ${page.title}`;
  element("title").textContent = page.title;
  element("notes").replaceChildren(...page.notes.map((note) => {
    const item = document.createElement("li");
    item.textContent = note;
    return item;
  }));
  element("about").open = page.simplified;
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
    angle() {
      const angle = Number(element("angle").value);
      element("angle-value").textContent = `${angle}\u00b0`;
      element("count").textContent = describeCount(scene.setAngle(angle), scene.axisMesh);
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
  element("angle").min = Math.floor(angles.origin);
  const initial = { angle: element("angle").min, opacity: 0.2, colour: "Radius" };
  for (const [id, value] of Object.entries({ ...initial, ...settingsOf(location.hash) })) {
    if (id in initial) {
      element(id).value = value;
    }
  }
  if (element("colour").selectedIndex < 0) {
    element("colour").value = initial.colour;
  }
}

function change(id, value) {
  element(id).value = value;
  element(id).dispatchEvent(new Event("input"));
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
    c: () => {
      const list = element("colour");
      change("colour", list.options[(list.selectedIndex + 1) % list.options.length].value);
    },
    r: () => element("reset").click(),
    h: () => { element("help").open = !element("help").open; },
  };
  // vtk.js has keys of its own, for wireframes and the like.
  window.addEventListener("keypress", (event) => event.stopImmediatePropagation(), true);
  window.addEventListener("keydown", (event) => {
    const action = actions[event.key] || actions[event.key.toLowerCase()];
    const typing = event.target instanceof HTMLElement && event.target.matches("input, select");
    if (action && !typing && !event.ctrlKey && !event.altKey && !event.metaKey) {
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
  element("reset").addEventListener("click", () => {
    scene.resetView();
    scene.draw();
  });
  element("reset").click();
  document.body.dataset.drawn = "yes";
}

try {
  start();
} catch (error) {
  element("failure").textContent = `The page cannot be shown: ${error.message}. It needs WebGL 2.`;
  element("failure").hidden = false;
}
