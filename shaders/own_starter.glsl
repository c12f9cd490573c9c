// Own shading: your lighting, held against the truth. Write it below, then
//   shading-sandbox capture ${scene} --technique ${frequency}/own --own FILE.glsl --out own.png
//   shading-sandbox compare ${scene} --left ${frequency}/own --own-left FILE.glsl --right ${reference}
//
// GLSL ES 3.00, as in a browser. Numbers of float are written 1.0. No #version, #extension or #include; #define NAME VALUE
// is accepted. All loops of one point together take at most ${turns} turns. Colours are linear. All is in world space.
//
// What you may read (what you do not name is not there, and costs nothing):
${interface}
//
// What you may define:
${entries}

${signature}
{
    return vec3(0.0);
}
