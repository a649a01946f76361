// SPDX-License-Identifier: MIT
// Draws a mesh file as three.js reads it, with the camera, the light and the shading of docs/shading.md.
import * as three from 'three'

// Of an extension: the module in three/addons/loaders/ and the class in it.
const loaders = {
  '3ds': 'TDSLoader', '3mf': 'ThreeMFLoader', amf: 'AMFLoader', dae: 'ColladaLoader', fbx: 'FBXLoader', glb: 'GLTFLoader',
  gltf: 'GLTFLoader', lwo: 'LWOLoader', md2: 'MD2Loader', obj: 'OBJLoader', ply: 'PLYLoader', stl: 'STLLoader',
  wrl: 'VRMLLoader',
}
// These take the colours of materials for sRGB, and we for linear light.
const sRgbColors = ['dae', 'fbx', 'obj']

async function makeLoader(kind, manager) {
  const name = loaders[kind]
  if (!name) throw new Error('three.js has no loader for it')
  const file = name === 'ThreeMFLoader' ? '3MFLoader' : name
  const loader = new (await import(`three/addons/loaders/${file}.js`))[name](manager)
  if (name === 'GLTFLoader') {
    loader.setMeshoptDecoder((await import('three/addons/libs/meshopt_decoder.module.js')).MeshoptDecoder)
    const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js')
    loader.setDRACOLoader(new DRACOLoader(manager).setDecoderPath('/three/examples/jsm/libs/draco/gltf/'))
  }
  return loader
}

// OBJLoader leaves the library of materials to its caller. Without one the file is read without it.
async function addMaterials(loader, url, manager) {
  const text = await (await fetch(url)).text()
  const [, library] = /^\s*mtllib\s+(.*\S)/m.exec(text) ?? []
  if (!library) return
  const { MTLLoader } = await import('three/addons/loaders/MTLLoader.js')
  const file = new URL(library.replaceAll('\\', '/'), new URL(url, location))
  try {
    loader.setMaterials(await new MTLLoader(manager).loadAsync(file.href))
  } catch (error) {
    if (error.response?.status !== 404) throw error
  }
}

// Of an OBJ, materials that no library has are made up by its loader; of others, those without a name.
function markMadeUp(object, known) {
  object.traverse((node) => {
    for (const material of [node.material ?? []].flat()) {
      const { name } = material
      material.userData.isMadeUp = known ? !(name in known) : ['', three.Loader.DEFAULT_MATERIAL_NAME].includes(name)
    }
  })
}

async function load(url, kind) {
  let pending = 0
  const manager = new three.LoadingManager()
  const { itemStart, itemEnd } = manager
  manager.itemStart = (what) => { pending += 1; itemStart(what) }
  manager.itemEnd = (what) => { pending -= 1; itemEnd(what) }
  const { TGALoader } = await import('three/addons/loaders/TGALoader.js')
  manager.addHandler(/\.tga$/i, new TGALoader(manager))
  const loader = await makeLoader(kind, manager)
  if (kind === 'obj') await addMaterials(loader, url, manager)
  const loaded = await loader.loadAsync(url)
  while (pending > 0) await new Promise((done) => setTimeout(done, 2)) // pictures that nobody awaits
  let object = loaded.scene ?? loaded
  if (loaded.meshes) { // LWOLoader's
    object = new three.Group()
    object.add(...loaded.meshes)
  }
  if (object.isBufferGeometry) {
    // PLYLoader and STLLoader know no materials, and STLLoader says of some files that they have colours.
    object = new three.Mesh(object, new three.MeshLambertMaterial({ vertexColors: object.hasAttribute('color') }))
  }
  if (!kind.startsWith('gl')) markMadeUp(object, kind === 'obj' ? loader.materials?.materialsInfo ?? {} : null)
  return object
}

function prepared(map) {
  if (!map?.image) return null // it was not found
  map.minFilter = map.magFilter = three.LinearFilter
  map.generateMipmaps = false
  map.anisotropy = 1
  map.needsUpdate = true
  return map
}

// What a file leaves open each reader decides for itself: here, as Assimp does for us. Colours of vertices are shown as
// they are.
const greys = { '3ds': 0.3, '3mf': 0.6, amf: 0.6, dae: 0.6, fbx: 0.8, lwo: 0.6, obj: 0.6 }

function colorOf(material, kind) {
  if (material.userData.isMadeUp) return new three.Color().setScalar(material.vertexColors ? 1 : greys[kind] ?? 1)
  const color = material.color?.clone() ?? new three.Color(1, 1, 1)
  return sRgbColors.includes(kind) ? color.convertLinearToSRGB() : color
}

// Diffuse as docs/shading.md has it: from both sides, the smooth normal on the facet's side. What is partly
// transparent is opaque there, and what is wholly transparent is cut out.
function diffuse(material, geometry, kind) {
  const shown = new three.MeshLambertMaterial({
    color: colorOf(material, kind),
    map: prepared(material.map),
    alphaMap: prepared(material.alphaMap),
    alphaTest: material.alphaTest || (material.transparent ? 1 / 512 : 0),
    opacity: material.opacity,
    vertexColors: material.vertexColors,
    flatShading: !geometry.hasAttribute('normal'),
    side: three.DoubleSide,
  })
  shown.onBeforeCompile = (shader) => {
    shader.fragmentShader = shader.fragmentShader.replace('#include <normal_fragment_maps>', `
      vec3 facet = cross(dFdx(vViewPosition), dFdy(vViewPosition));
      if (dot(normal, facet) < 0.0) normal = -normal;`)
  }
  return shown
}

// Leaves of a file what is drawn: triangles. Returns their box, in the file's units.
function prepare(object, kind) {
  object.traverse((node) => {
    if (node.isLight) node.intensity = 0
    if (!node.geometry && !node.isSprite) return
    if (!node.isMesh) {
      node.geometry = new three.BufferGeometry()
      return
    }
    node.frustumCulled = false
    const relit = (material) => diffuse(material, node.geometry, kind)
    node.material = Array.isArray(node.material) ? node.material.map(relit) : relit(node.material)
  })
  // Up is z in 3DS; TDSLoader leaves it to its caller.
  if (kind === '3ds') object.rotation.x = -Math.PI / 2
  // LightWave's axes are left-handed. LWOLoader mirrors z, and Assimp mirrors x: half a turn lies between them.
  if (kind === 'lwo') object.rotation.y = Math.PI
  object.updateMatrixWorld(true)
  return new three.Box3().setFromObject(object, true)
}

const renderer = new three.WebGLRenderer({ antialias: false })

// draw(URL, KIND, {width, height, fov, eye, key}): the picture as base64 of floats, RGBA, linear, upper row first, and
// the scale and then the position that let the file fill it. `fov` is horizontal, in degrees; `eye` looks at the origin
// and is where the light is; `key` is the colour of the background.
window.draw = async (url, kind, { width, height, fov, eye, key }) => {
  const object = await load(url, kind)
  const box = prepare(object, kind)
  if (box.isEmpty()) throw new Error('it has no triangles')
  const scale = 2 / box.getSize(new three.Vector3()).length()
  if (!Number.isFinite(scale) || scale === 0) throw new Error('its triangles are all in one place, or endlessly far away')
  const position = box.getCenter(new three.Vector3()).multiplyScalar(-scale)

  const scene = new three.Scene()
  const placed = new three.Group()
  placed.scale.setScalar(scale)
  placed.position.copy(position)
  placed.add(object)
  scene.add(placed)
  const slope = Math.tan(three.MathUtils.degToRad(fov / 2)) * height / width
  const camera = new three.PerspectiveCamera(three.MathUtils.radToDeg(2 * Math.atan(slope)), width / height, 0.1, 100)
  camera.position.fromArray(eye)
  camera.lookAt(0, 0, 0)
  const light = new three.PointLight(0xffffff, Math.PI * camera.position.lengthSq()) // there a diffuse surface gives 1/π
  light.position.copy(camera.position)
  scene.add(light)

  // A target of floats keeps linear light as it is.
  const target = new three.WebGLRenderTarget(width, height, { type: three.FloatType })
  renderer.setRenderTarget(target)
  renderer.setClearColor(new three.Color().setRGB(...key), 1)
  renderer.render(scene, camera)
  const pixels = new Float32Array(4 * width * height)
  renderer.readRenderTargetPixels(target, 0, 0, width, height, pixels)
  target.dispose()
  renderer.renderLists.dispose()
  const rows = []
  for (let y = height - 1; y >= 0; y -= 1) {
    rows.push(...pixels.subarray(4 * width * y, 4 * width * (y + 1)))
  }
  const bytes = new Uint8Array(Float32Array.from(rows).buffer)
  let text = ''
  for (const byte of bytes) text += String.fromCharCode(byte)
  return { scale, position: position.toArray(), pixels: btoa(text) }
}
