"""Faults to seed: (file below sandbox/, context that occurs once in it, expression in the context, what it becomes)."""

LIGHTING = "reference/lighting.cpp"
BRANCHES = "reference/branches.cpp"
FRAGMENT = "reference/fragment.cpp"
SURFACE = "reference/surface.cpp"
RASTER = "reference/raster.cpp"
RASTER_H = "reference/raster.h"
MESH_SCENE = "reference/mesh_scene.cpp"
MESH_PICTURE = "reference/mesh_picture.cpp"
ANALYTIC_PICTURE = "reference/analytic_picture.cpp"
METRICS = "measure/metrics/metrics.cpp"

MUTANTS = [
    # The equation.
    (LIGHTING, "return 2 * std::pow(std::sin(glm::radians(degrees) / 2), 2)", "glm::radians(degrees) / 2", "glm::radians(degrees) / 2.001"),
    (LIGHTING, "return t * t * (3 - 2 * t);", "t * t * (3 - 2 * t)", "t"),
    (LIGHTING, "setup.travel = unit(light.direction);", "unit(light.direction)", "light.direction"),
    (LIGHTING, "terms.c < light.cos_outer ? 0", "terms.c < light.cos_outer", "terms.c < light.cos_inner"),
    (LIGHTING, "power_of_dot(-terms.vectors.l, light.travel, light.light.exponent)", "light.light.exponent", "light.light.exponent + 1"),
    (LIGHTING, "return n_dot_l > 0;", "n_dot_l > 0", "n_dot_l >= -1e-3"),
    (LIGHTING, "return glm::dot(n, v) > 0;", "glm::dot(n, v) > 0", "n_dot_l > 0"),
    (LIGHTING, "terms.f = std::max(glm::dot(a, b), 0.0)", "std::max(glm::dot(a, b), 0.0)", "glm::dot(a, b)"),
    (LIGHTING, "cosine > 0.5 ? std::log1p", "cosine > 0.5", "cosine > 2"),
    (LIGHTING, "logarithm += std::log(lengths);", "std::log(lengths)", "0.0"),
    (LIGHTING, "1 / std::max(k.constant + (k.linear + k.quadratic * d) * d, attenuation_floor)", "k.linear + k.quadratic * d", "k.linear + k.quadratic"),
    (LIGHTING, "k.quadratic * d) * d, attenuation_floor)", "attenuation_floor", "1e-5"),
    (LIGHTING, "vectors.l = vectors.d == 0 ? n : unit(to_light)", "vectors.d == 0", "false"),
    (LIGHTING, "vectors.r = 2 * glm::dot(n, vectors.l) * n - vectors.l", "2 * glm::dot(n, vectors.l)", "1.9999 * glm::dot(n, vectors.l)"),
    (LIGHTING, "vectors.h = vectors.h == glm::dvec3(0) ? n : vectors.h", "vectors.h == glm::dvec3(0)", "false"),
    (LIGHTING, "light.light.attenuate_ambient ? reach : 1", "light.light.attenuate_ambient ? reach : 1", "reach"),
    (LIGHTING, "std::max(incidence, 0.0) * reach", "std::max(incidence, 0.0)", "std::abs(incidence)"),
    (LIGHTING, "material.texture_modulates_specular ? base : glm::dvec3(1)", "material.texture_modulates_specular", "true"),
    (LIGHTING, "setup.view_axis = -camera_axes(scene.camera).forward", "-camera_axes(scene.camera).forward", "camera_axes(scene.camera).forward"),
    (LIGHTING, "light.light.inner_cutoff_degrees < light.light.cutoff_degrees && terms.s != 0", "terms.s != 0", "terms.s == 0"),
    # The surface.
    (SURFACE, "normals != Normals::cofactor && glm::dot(a[0], cofactor[0]) < 0 ? -cofactor : cofactor", "glm::dot(a[0], cofactor[0]) < 0", "false"),
    (SURFACE, "return transformed == glm::dvec3(0) ? n : transformed", "transformed == glm::dvec3(0)", "false"),
    (SURFACE, "const double x = uv.x * image.size.width - 0.5", "uv.x * image.size.width - 0.5", "uv.x * image.size.width"),
    (SURFACE, "return glm::mix(below, above, y - j)", "y - j", "x - i"),
    (SURFACE, "texel(image, i + 1, j + 1)", "i + 1", "i"),
    (SURFACE, "glm::floor(checker_coordinates(checker, half_extent, p)), 0.0, checker.cells - 1.0", "checker.cells - 1.0", "checker.cells + 1.0"),
    (SURFACE, "checker.colors[std::fmod(sum, 2) == 0 ? 0 : 1]", "std::fmod(sum, 2) == 0", "std::fmod(sum, 2) != 0"),
    (SURFACE, "std::abs(cell[axis] - boundary) < margin[axis]", "margin[axis]", "rounding[axis]"),
    (SURFACE, "boundary > 0 && boundary < checker->cells", "boundary > 0", "true"),
    # Triangles and pixels.
    (RASTER, "slope.x > 0 || (slope.x == 0 && slope.y > 0)", "slope.y > 0", "slope.y < 0"),
    (RASTER, "lead > 0", "lead > 0", "lead < 0"),
    (RASTER, "kept.tie = kept.tie || tie", "kept.tie || tie", "kept.tie"),
    (RASTER, "distance * distance < (g.x * g.x + g.y * g.y) * (edge_width * edge_width)", "edge_width * edge_width", "edge_width * edge_width / 16"),
    (RASTER, "farthest < depth_.near || nearest > depth_.far", "farthest < depth_.near", "nearest < depth_.near"),
    (RASTER, "hit.beside > hit.inverse_w - hit.resolution", "hit.inverse_w - hit.resolution", "2 * hit.inverse_w"),
    (RASTER, "edges.sign == 0 || edges.sign == object.hidden", "edges.sign == object.hidden", "edges.sign == -object.hidden"),
    (RASTER_H, "inverse_w * near <= 1 && inverse_w * far >= 1", "inverse_w * far >= 1", "true"),
    (RASTER_H, "inverse_w * near <= 1 && inverse_w * far >= 1", "inverse_w * near <= 1", "true"),
    (RASTER, "hit.beside = std::max(hit.beside, beside <= depth_.nearest() ? beside : 0)", "beside <= depth_.nearest() ? beside : 0", "0.0"),
    (MESH_SCENE, "return glm::dot(normal, mean) < 0 ? -normal : normal", "glm::dot(normal, mean) < 0", "false"),
    (MESH_SCENE, "p[triangle.x] + p[triangle.y] + p[triangle.z]) / 3.0", "/ 3.0", "/ 3.0001"),
    (FRAGMENT, "point.raw_normal = unit(point.raw_normal)", "unit(point.raw_normal)", "point.raw_normal"),
    (FRAGMENT, "return a + weights.y * (b - a) + weights.z * (c - a)", "weights.z * (c - a)", "weights.y * (c - a)"),
    (FRAGMENT, "vectors.l = unit_or(interpolated(&LightVectors::l), point.normal)", "unit_or(interpolated(&LightVectors::l), point.normal)", "interpolated(&LightVectors::l)"),
    (FRAGMENT, "vectors.d = interpolated(&LightVectors::d)", "interpolated(&LightVectors::d)", "glm::length(setup.position - point.position)"),
    (ANALYTIC_PICTURE, "axes.up * ((1 - 2 * y / size.height) * half_height)", "1 - 2 * y / size.height", "2 * y / size.height - 1"),
    (ANALYTIC_PICTURE, "a.object != b.object || a.hit.part != b.hit.part", "a.hit.part != b.hit.part", "false"),
    # The masks.
    (BRANCHES, "std::abs(q) < std::abs(quantity(*right_) - q) + std::abs(quantity(*below_) - q) + noise", "std::abs(quantity(*below_) - q)", "0.0"),
    (BRANCHES, "std::abs(q) < std::abs(quantity(*right_) - q) + std::abs(quantity(*below_) - q) + noise", "std::abs(quantity(*right_) - q)", "1.0"),
    (BRANCHES, "const bool at_cone = steps && close(beyond_cone, in_cone + edge / 2)", "steps && close(beyond_cone, in_cone + edge / 2)", "false"),
    (BRANCHES, "const bool at_gate = (gated || where_lit) && close(n_dot_l, dot_noise)", "(gated || where_lit) && close(n_dot_l, dot_noise)", "false"),
    (BRANCHES, "const bool gated = adds_highlight() && setup_.technique.gate == Gate::light_facing", "setup_.technique.gate == Gate::light_facing", "true"),
    (BRANCHES, "doubts_.jump.body += where_lit ? amount.ambient : glm::dvec3(0)", "where_lit ? amount.ambient : glm::dvec3(0)", "glm::dvec3(0)"),
    (BRANCHES, "doubts_.jump.body += amount.diffuse * std::max(terms.n_dot_l, 0.0)", "std::max(terms.n_dot_l, 0.0)", "1.0"),
    (BRANCHES, "n == 0 || n > steep_exponent", "n > steep_exponent", "true"),
    (BRANCHES, "jump > negligible_jump, noise > negligible_noise", "jump > negligible_jump", "jump >= 0"),
    (BRANCHES, "jump > negligible_jump, noise > negligible_noise", "noise > negligible_noise", "false"),
    (BRANCHES, "return rounding * spread(setup, light, position, d) > far_from_a_branch", "> far_from_a_branch", "> 1e3 * far_from_a_branch"),
    (BRANCHES, "here_.normal_length < short_vector", "here_.normal_length < short_vector", "false"),
    (METRICS, "if (left.id(i) != right.id(i)) {\n        return PixelUse::silhouette", "left.id(i) != right.id(i)", "left.id(i) < right.id(i)"),
    (METRICS, "if (masked(&ReferenceFrame::edge))", "masked(&ReferenceFrame::edge)", "false"),
    (METRICS, "std::ceil(0.99 * count)) - 1", "0.99 * count", "0.98 * count"),
    (METRICS, "norms.rmse = std::sqrt(squares / count)", "squares / count", "squares / (count - 1)"),
    (METRICS, "if (metrics.compared_pixels == 0) {\n        metrics.norms = nothing_compared", "metrics.compared_pixels == 0", "false"),
    (METRICS, "metrics.compared_pixels + masked", "metrics.compared_pixels + masked", "metrics.compared_pixels + 2 * masked"),
]
