// Relief, or the extrusion of a shape, over a curved mesh.
//
//   MESH_SOLID  0 relief (curved_march.glsl), 1 extrusion (curved_extrusion.glsl)
//   MESH_TRACE  the technique's function
//   MESH_KEEP   1 when pixels beyond the silhouette are kept behind everything, with what their march cost, to be measured; else they
//               are discarded
//   MESH_TWIST  1 with c, 0 without

uniform vec3 camera_eye;
uniform vec3 camera_forward;
uniform vec2 camera_range;     // near, far
uniform vec2 mesh_tiles;       // repeats of the map over one unit of texture coordinates
uniform vec2 mesh_repeat;      // per axis: 1 the map repeats, 0 clamps
uniform vec2 mesh_ends;        // per axis: 1 where the map ends with the mesh, at texture coordinates 0 and 1
uniform float mesh_depth_scale; // depth of the relief, in the mesh's unit
uniform float mesh_normal_scale; // depth of the relief that the map's normals were baked for, texture widths (MESH_SOLID 0)
uniform float mesh_aspect;     // height / width of the map

in vec3 mesh_sight;
in vec3 mesh_normal;
in vec4 mesh_tangent;
in vec2 mesh_uv;
in vec3 mesh_quadric;
in vec4 mesh_chart;
in vec3 mesh_bend_u;
in vec3 mesh_bend_v;

layout(location = 0) out vec4 out_colour; // linear, tone-mapped; a: 1 where drawn
layout(location = 1) out vec4 out_place;  // distance from the eye, steps, fetches, status

vec3 unit_or(vec3 v, vec3 other) {
    float size = length(v);
    return size > 1e-12 ? v / size : other;
}

// The normal at a place, over (tangent, bitangent, up) there. A chart column holds the change of uv along an axis.
vec3 relief_in_frame(CurvedPlace place, mat2 chart) {
#if MESH_SOLID
    if (place.depth >= 0.999) return vec3(0.0, 0.0, 1.0);
    vec2 g = shape_gradient(solid_texel(curved_solid_place(place)));
    if (dot(g, g) == 0.0 || place.depth < 1e-4) return vec3(0.0, 0.0, 1.0);
    float lean = place.depth < solid_chamfer ? solid_bevel : 0.0;
    vec2 across = g * vec2(1.0, shape_aspect) * chart; // change of the distance along x and y
    return unit_or(vec3(across, lean), vec3(0.0, 0.0, 1.0));
#else
    vec3 n = relief_normal(textureLod(relief_map, place.uv, 0.0));
    vec2 slope = -n.xy / max(n.z, 1e-3) / mesh_normal_scale; // change of height per texture width, x along u, y up the image
    return unit_or(vec3(-(vec2(slope.x, -mesh_aspect * slope.y) * chart), 1.0), vec3(0.0, 0.0, 1.0));
#endif
}

void main() {
    if (!gl_FrontFacing) discard;
    vec3 view = unit_or(mesh_sight, camera_forward);
    vec3 up = unit_or(mesh_normal, -view);
    vec3 across = mesh_tangent.xyz - dot(mesh_tangent.xyz, up) * up;
    vec3 tangent = unit_or(across, unit_or(cross(up, abs(up.x) < 0.7 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)), vec3(0.0)));
    vec3 bitangent = (mesh_tangent.w < 0.0 ? -1.0 : 1.0) * cross(up, tangent);

    CurvedRay ray;
    vec2 uv = mesh_uv * mesh_tiles;
    vec2 tile = floor(uv) * mesh_repeat; // kept apart, so that uv keeps its precision
    ray.origin = uv - tile;
    ray.ends = vec4(-tile, mesh_tiles - tile);
    if (mesh_ends.x == 0.0) ray.ends.xz = vec2(-1e30, 1e30);
    if (mesh_ends.y == 0.0) ray.ends.yw = vec2(-1e30, 1e30);
    ray.sight = vec3(dot(view, tangent), dot(view, bitangent), dot(view, up));
    ray.quadric = mesh_depth_scale * mesh_quadric;
    ray.unit = 1.0 / mesh_depth_scale;
#if !MESH_TWIST
    ray.quadric.z = 0.0;
#endif
    vec4 chart = mesh_depth_scale * mesh_chart * mesh_tiles.xxyy;
    ray.chart = mat2(chart.x, chart.z, chart.y, chart.w);
    ray.bend_u = clamp(mesh_depth_scale * mesh_tiles.x * (mesh_depth_scale * mesh_bend_u), -1e12, 1e12); // finite, whatever the mesh holds
    ray.bend_v = clamp(mesh_depth_scale * mesh_tiles.y * (mesh_depth_scale * mesh_bend_v), -1e12, 1e12);

    CurvedHit hit = MESH_TRACE(ray);
    out_place = vec4(0.0, float(hit.steps), float(hit.fetches), float(hit.status));
    if (hit.status == CURVED_LEFT) {
#if MESH_KEEP
        out_colour = vec4(0.0);
        gl_FragDepth = 1.0;
        return;
#else
        discard;
#endif
    }
    vec3 sight = mesh_sight + (hit.t * mesh_depth_scale) * view;
    CurvedPlace place = curved_place(ray, hit.t);
    vec3 local = relief_in_frame(place, ray.chart);
    // The frame turns with the surface.
    vec3 x_axis = unit_or(vec3(1.0, 0.0, 0.0) - place.up.x * place.up, vec3(0.0, 1.0, 0.0));
    vec3 y_axis = cross(place.up, x_axis);
    vec3 normal = local.x * x_axis + local.y * y_axis + local.z * place.up;
    normal = unit_or(normal.x * tangent + normal.y * bitangent + normal.z * up, up);

    out_colour = vec4(lit_clay(normal), 1.0);
    out_place.x = length(sight);
    float ahead = max(dot(sight, camera_forward), camera_range.x);
    gl_FragDepth = clamp(camera_range.y * (1.0 - camera_range.x / ahead) / (camera_range.y - camera_range.x), 0.0, 1.0);
}
