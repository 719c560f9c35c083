// Exact hidden-line removal: see README.md.

/** A mesh in any unit. Vertices are numbered from 0. */
export interface Mesh {
  /** x, y and z of each vertex. Without `index`, `faces` and `polylines`, every three vertices are a triangle. */
  positions: Float32Array | Float64Array;
  /** Three vertices for each triangle, counterclockwise as seen from outside. */
  index?: Uint32Array | Uint16Array;
  /** Instead of `index`: faces of any number of vertices, each a list of vertices, or a list of its outline and its holes. */
  faces?: ArrayLike<Ring | ArrayLike<Ring>>;
  /** Lines that hide nothing, each a list of vertices. */
  polylines?: ArrayLike<Ring>;
  /** The number of each face's body, from 0. Without it, faces that an edge joins are one body. */
  bodies?: ArrayLike<number>;
}

export type Ring = ArrayLike<number>;
export type Point = readonly [number, number, number] | Float32Array | Float64Array;

export interface CallOptions {
  /** Ends the work when it is aborted; the promise rejects with its reason, an AbortError. */
  signal?: AbortSignal;
  /** Called now and then during long work with the part that is done, from 0 to 1. */
  progress?: (done: number) => void;
}

export interface SceneOptions {
  /** Repairs damage of the mesh. Without it, the first damage is an error. Default: true. */
  mend?: boolean;
  /** Vertices at most this far apart become one. Default: 0. */
  weld?: number;
  /** Vertices this near to the plane of a larger neighbour belong to its surface. */
  planarTolerance?: number;
  /**
   * An eye from which the scene will be drawn. The grid is then chosen for it: finer for a mesh of small whole numbers, whose grid has
   * steps of 1 otherwise; coarser for an eye far outside.
   */
  eye?: Point;
}

export type View = 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom' | 'iso' | 'dimetric' | 'trimetric' | 'NE' | 'NW' | 'SE' | 'SW';

export interface Camera {
  /** A standard view, in parallel projection. */
  view?: View;
  /** Shows `view` in perspective. */
  perspective?: boolean;
  /** Parallel projection in this direction. */
  direction?: Point;
  /** Perspective from this point, at `lookAt` or the middle of the scene. */
  eye?: Point;
  lookAt?: Point;
  /** Points up on the drawing. */
  up?: Point;
  /** The axis of the scene that points up. Default: 'y'. */
  vertical?: 'x' | 'y' | 'z' | '-x' | '-y' | '-z';
}

export interface DrawOptions extends Camera {
  /** 'feature' (default), 'all', or kinds separated by commas: silhouette, boundary, crease, intersection, wire. */
  edges?: string;
  /** The least angle between the faces at a crease, in degrees. Default: 30. */
  crease?: number;
  /** Also the hidden parts of the edges. Default: false. */
  hidden?: boolean;
  /** The size of the drawing. Default: 200 by 200, which a file takes as millimetres. */
  width?: number;
  height?: number;
  /** Units of the drawing per unit of the mesh, in parallel projection, instead of fitting. */
  scale?: number;
  /** The angle of the image across its shorter side in degrees, in perspective, instead of fitting. */
  field?: number;
  /** Shorter lines that join no others are left out. Default: 0. */
  minLength?: number;
}

export interface FileOptions {
  title?: string;
  /** Millimetres around the drawing. Default: 10. */
  margin?: number;
  /** The width of lines in millimetres. Default: 0.2. */
  pen?: number;
  /** Keeps the order of the lines; otherwise the way of a raised pen is made short. */
  asFound?: boolean;
}

/** The kinds of edges: kindNames[0] is the name of kind 0. */
export declare const kindNames: readonly ['silhouette', 'junction', 'boundary', 'crease', 'border', 'intersection', 'polyline', 'flat'];

/** In columns of numbers: there is no such face, vertex or body. */
export declare const none: 0xffffffff;

/** The version of this package. */
export declare const version: string;

/** A drawing: plain columns of numbers, made by Scene.draw and hiddenLines. */
export declare class Drawing {
  private constructor();
  /** Four numbers for each line: x and y of both ends, from the bottom left corner. */
  readonly lines: Float64Array;
  /** The kind of each line. */
  readonly kinds: Uint8Array;
  /** 1 for each hidden line. */
  readonly hidden: Uint8Array;
  /** The edges that lie on line i: lineEdges[lineEdgeOffsets[i]] up to lineEdges[lineEdgeOffsets[i + 1] - 1]. */
  readonly lineEdges: Uint32Array;
  readonly lineEdgeOffsets: Uint32Array;
  /** The exact parts of the edges. */
  readonly parts: {
    readonly edges: Uint32Array;
    /** Four numbers for each part: numerator and denominator of its beginning, then those of its end, as parts of the edge. */
    readonly fractions: BigInt64Array;
    readonly hidden: Uint8Array;
    /** A face that hides the part. none: it is visible, behind the eye, or hidden by its own solid. */
    readonly hiddenBy: Uint32Array;
  };
  /** The edges that have a part. */
  readonly edges: {
    readonly kinds: Uint8Array;
    /** Six numbers for each edge: both ends, in the unit of the mesh. */
    readonly ends: Float64Array;
    /** Two vertices for each edge. none: the end of an intersection. */
    readonly vertices: Uint32Array;
    /** The body of each edge. none: of a polyline. */
    readonly bodies: Uint32Array;
    /** The faces at edge i: faces[faceOffsets[i]] up to faces[faceOffsets[i + 1] - 1]. */
    readonly faces: Uint32Array;
    readonly faceOffsets: Uint32Array;
  };
  /** x = axes[0] . (p - eye), y = axes[1] . (p - eye), in perspective both divided by axes[2] . (p - eye), is drawn at scale * ((x, y) - low). */
  readonly camera: {
    readonly perspective: boolean;
    readonly eye: number[];
    readonly axes: number[][];
    readonly scale: number;
    readonly low: number[];
    /** Degrees between the direction of view and the one asked for. */
    readonly error: number;
  };
  readonly width: number;
  readonly height: number;
  /** Sentences on what was left out. */
  readonly notes: string[];
  /** The drawing as an SVG file. */
  svg(options?: FileOptions): string;
  /** The drawing as the bytes of a file. */
  file(options?: FileOptions & { format?: 'svg' | 'pdf' | 'dxf' | 'hpgl' | 'steps' }): Uint8Array;
}

/** A mesh, rounded to its grid, repaired and checked, for many drawings. */
export declare class Scene {
  private constructor();
  /** With `worker`, all work on the scene is done in a worker of its own. */
  static of(mesh: Mesh, options?: SceneOptions & CallOptions & { worker?: boolean }): Promise<Scene>;
  draw(options?: DrawOptions & CallOptions): Promise<Drawing>;
  /** Gives up the memory and the worker of the scene. Its drawings stay. */
  free(): void;
  /** After repairs. */
  readonly faceCount: number;
  readonly vertexCount: number;
  /** The least and the greatest coordinates, in the unit of the mesh. */
  readonly bounds: number[][];
  /** The step of the grid, in the unit of the mesh. */
  readonly step: number;
  /** Sentences on what rounding and repairs changed. */
  readonly notes: string[];
}

/** One drawing of a mesh. */
export declare function hiddenLines(mesh: Mesh, options?: SceneOptions & DrawOptions & CallOptions & { worker?: boolean }): Promise<Drawing>;

/** What promises reject with. The message names the argument, the place in it, what was found and what was expected. */
export declare class SightlineError extends Error {
  constructor(message: string, properties: { kind: SightlineError['kind']; argument?: string; place?: string; found?: string; expected?: string });
  /**
   * bad_input: the mesh is wrong, or the eye is inside a solid; usage: an option is wrong; io: the module or the worker cannot be loaded;
   * cancelled: the scene was freed; out_of_memory; defect: of this package.
   */
  readonly kind: 'bad_input' | 'usage' | 'io' | 'cancelled' | 'out_of_memory' | 'defect';
  /** 'mesh' or the name of an option. */
  readonly argument: string;
  /** In the mesh: 'index[5]'. */
  readonly place: string;
  readonly found: string;
  readonly expected: string;
}
