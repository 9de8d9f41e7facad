// The data of the page: JSON with base64 of little-endian integers (docs/WEB.md).

function bytes(base64) {
  const text = atob(base64);
  const result = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) {
    result[i] = text.charCodeAt(i);
  }
  return result;
}

// Coordinates x, y, z of every point, from the corner of the frame and in its widest steps: single
// precision would not do for meshes far from the origin.
function decodePoints(mesh, frame) {
  const unit = Math.max(...frame.step) || 1;
  const scale = frame.step.map((step) => step / unit);
  const steps = new Uint16Array(bytes(mesh.points).buffer);
  return Float32Array.from(steps, (step, i) => scale[i % 3] * step);
}

function decodeArray(array) {
  const steps = new Uint16Array(bytes(array.values).buffer);
  return Float32Array.from(steps, (step) => array.origin + array.step * step);
}

// Cells of `size` corners each, those of the greatest angles first. `angles` has the least angle of
// each cell's corners; null where the mesh has no angles.
function decodeCells(base64, size, pointAngles) {
  const corners = new Uint32Array(bytes(base64).buffer);
  const count = corners.length / size;
  const list = new Uint32Array(count * (size + 1)); // as VTK has it: size, corners, size, ...
  const angles = pointAngles && new Float32Array(count);
  for (let cell = 0; cell < count; ++cell) {
    const ids = corners.subarray(cell * size, (cell + 1) * size);
    list[cell * (size + 1)] = size;
    list.set(ids, cell * (size + 1) + 1);
    if (angles) {
      angles[cell] = Math.min(...Array.from(ids, (id) => pointAngles[id]));
    }
  }
  return { size, count, list, angles };
}

// How many cells, from the first on, have at least this angle.
function countFrom(cells, angle) {
  let low = 0;
  let high = cells.count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (cells.angles[middle] >= angle) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

function decodeMesh(mesh, frame) {
  const arrays = mesh.arrays.map((array) => ({ ...array, values: decodeArray(array) }));
  const angles = arrays.find((array) => array.name === "SeparationAngle");
  const cells = (name, size) => decodeCells(mesh[name], size, angles ? angles.values : null);
  return {
    points: decodePoints(mesh, frame),
    arrays,
    triangles: cells("triangles", 3),
    lines: cells("lines", 2),
    vertices: cells("vertices", 1),
  };
}
