uniform vec3 checker_colors[2];
uniform float checker_cells_per_unit;
uniform float checker_half_cells;

// Colour by object-space position: cells of equal size across the object's bounding cube. Clamped, because a face of the
// cube lies on a border between a cell and nothing.
vec3 checker_color(vec3 position)
{
    vec3 cell = floor(position * checker_cells_per_unit + checker_half_cells);
    cell = clamp(cell, 0.0, 2.0 * checker_half_cells - 1.0);
    return mod(cell.x + cell.y + cell.z, 2.0) < 0.5 ? checker_colors[0] : checker_colors[1];
}
