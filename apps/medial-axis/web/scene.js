// Surface and axis, drawn by vtk.js.

function makePolyData(mesh) {
  const data = vtk.Common.DataModel.vtkPolyData.newInstance();
  data.getPoints().setData(mesh.points, 3);
  for (const { name, values } of mesh.arrays) {
    data.getPointData().addArray(
      vtk.Common.Core.vtkDataArray.newInstance({ name, values, numberOfComponents: 1 }));
  }
  data.getPolys().setData(mesh.triangles.list, 1);
  data.getLines().setData(mesh.lines.list, 1);
  data.getVerts().setData(mesh.vertices.list, 1);
  return data;
}

function makeActor(data) {
  const mapper = vtk.Rendering.Core.vtkMapper.newInstance();
  mapper.setInputData(data);
  const actor = vtk.Rendering.Core.vtkActor.newInstance();
  actor.setMapper(mapper);
  return actor;
}

function makeSurface(mesh) {
  const actor = makeActor(makePolyData(mesh));
  actor.getMapper().setScalarVisibility(false);
  const look = actor.getProperty();
  look.setColor(0.62, 0.66, 0.72);
  look.setSpecular(0.3);
  look.setSpecularPower(30);
  return actor;
}

function makeAxis(mesh) {
  const actor = makeActor(makePolyData(mesh));
  const mapper = actor.getMapper();
  mapper.setScalarModeToUsePointFieldData();
  mapper.setColorModeToMapScalars();
  mapper.setInterpolateScalarsBeforeMapping(true);
  const look = actor.getProperty();
  look.setAmbient(0.35);
  look.setDiffuse(0.75);
  look.setLineWidth(2);
  look.setPointSize(3);
  return actor;
}

// Which of axis and skeleton each choice shows.
const SHOWN = { skeleton: [false, true], axis: [true, false], both: [true, true] };

function makeSkeleton(mesh) {
  const actor = makeAxis(mesh);
  actor.getProperty().setPointSize(8);
  actor.getProperty().setColor(0.15, 0.17, 0.2);
  return actor;
}

// Looks at all of the bounds as one of the page's views does.
function aimCamera(renderer, bounds, view) {
  const camera = renderer.getActiveCamera();
  camera.setFocalPoint(0, 0, 0);
  camera.setPosition(...view.direction.map((x) => -x));
  camera.setViewUp(...view.up);
  renderer.resetCamera(bounds);
  renderer.resetCameraClippingRange();
}

// Lights the front as usual, by vtk.js's light at the camera, and the edge as pictures do, also from
// the front. A camera light is at the camera by default. It is not a head light, since vtk.js treats
// the world direction of a second one as a direction in the view.
function setLights(renderer, { front, edgeLights }, isEdge) {
  const { vtkLight } = vtk.Rendering.Core;
  renderer.removeAllLights();
  if (isEdge) {
    renderer.addLight(
      vtkLight.newInstance({ lightType: "CameraLight", intensity: edgeLights.own }));
    renderer.addLight(vtkLight.newInstance({ lightType: "SceneLight",
      intensity: edgeLights.front, position: front.direction.map((x) => -x) }));
  }
}

// Whether the camera looks where a view does, however near.
function looksAlong(camera, view) {
  const direction = camera.getDirectionOfProjection();
  return direction.reduce((sum, x, i) => sum + x * view.direction[i], 0) > 0.999999;
}

// What the controls need: functions that change the picture and draw it again.
function makeScene(container, page) {
  const view = vtk.Rendering.Misc.vtkGenericRenderWindow.newInstance({ background: [1, 1, 1] });
  view.setContainer(container);
  view.resize();
  const renderer = view.getRenderer();
  const surfaceMesh = decodeMesh(page.surface, page.frame);
  const axisMesh = decodeMesh(page.axis, page.frame);
  const surface = makeSurface(surfaceMesh);
  const axis = makeAxis(axisMesh);
  const skeleton = page.skeleton && makeSkeleton(decodeMesh(page.skeleton, page.frame));
  renderer.addActor(axis);
  if (skeleton) {
    renderer.addActor(skeleton);
  }
  renderer.addActor(surface);
  const data = axis.getMapper().getInputData();
  const bounds = surfaceMesh.points.length > 0 ? surface.getBounds() : axis.getBounds();
  const draw = () => view.getRenderWindow().render();
  const look = (name) => {
    aimCamera(renderer, bounds, page.views[name]);
    setLights(renderer, page.views, name === "edge");
  };

  return {
    axisMesh,
    hasSkeleton: Boolean(skeleton),
    draw,
    show(choice) {
      axis.setVisibility(SHOWN[choice][0]);
      if (skeleton) {
        skeleton.setVisibility(SHOWN[choice][1]);
      }
    },
    resetView() {
      look("front");
    },
    // Looks edge-on, or from the front where it does so already.
    turnToEdge() {
      look(looksAlong(renderer.getActiveCamera(), page.views.edge) ? "front" : "edge");
    },
    setOpacity(opacity) {
      surface.setVisibility(opacity > 0);
      surface.getProperty().setOpacity(opacity);
    },
    // Shows the cells of at least this angle, the front part of each list.
    setAngle(angle) {
      const lists = {
        triangles: data.getPolys(),
        lines: data.getLines(),
        vertices: data.getVerts(),
      };
      const shown = {};
      for (const [kind, list] of Object.entries(lists)) {
        const cells = axisMesh[kind];
        shown[kind] = countFrom(cells, angle);
        list.setData(cells.list.subarray(0, shown[kind] * (cells.size + 1)), 1);
      }
      data.modified();
      return shown;
    },
    setColour(array, colours) {
      const map = vtk.Rendering.Core.vtkColorTransferFunction.newInstance();
      for (const [share, red, green, blue] of colours) {
        map.addRGBPoint(share * array.max, red, green, blue);
      }
      const mapper = axis.getMapper();
      mapper.setLookupTable(map);
      mapper.setUseLookupTableScalarRange(true);
      mapper.setColorByArrayName(array.name);
      if (skeleton) { // it has a radius only
        const ofSkeleton = skeleton.getMapper();
        ofSkeleton.setScalarVisibility(array.name === "Radius");
        ofSkeleton.setLookupTable(map);
        ofSkeleton.setUseLookupTableScalarRange(true);
        ofSkeleton.setColorByArrayName("Radius");
      }
    },
  };
}
