uniform vec3 checker_colors[2];
uniform float checker_cells_per_unit;
uniform vec3 checker_whole; // cells below the mesh's middle: whole ones and the rest, because together they lose digits
uniform vec3 checker_rest;
uniform float checker_last; // the last cell along each axis

// Colour by object-space position: cells of equal size across the object's bounding cube. Clamped, because a face of the
// cube lies on a border between a cell and nothing.
vec3 checker_color(vec3 position)
{
    vec3 cell = floor(position * checker_cells_per_unit + checker_rest) + checker_whole;
    cell = clamp(cell, 0.0, checker_last);
    return mod(cell.x + cell.y + cell.z, 2.0) < 0.5 ? checker_colors[0] : checker_colors[1];
}
