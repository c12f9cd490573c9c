#pragma once

/// OpenGL: its functions as glad has loaded them, or those of a browser's WebGL 2, which are linked.
#ifndef __EMSCRIPTEN__
#include <glad/gl.h>
#else
#include <GLES3/gl3.h>

// What OpenGL 3.3 has besides, so that what asks is_es() first compiles here too.
constexpr GLenum GL_TEXTURE_WIDTH = 0x1000, GL_TEXTURE_HEIGHT = 0x1001, GL_SAMPLES_PASSED = 0x8914,
                 GL_TIME_ELAPSED = 0x88BF;
inline void glGetTexLevelParameteriv(GLenum, GLint, GLenum, GLint *) {}
inline void glGetQueryObjectui64v(GLuint, GLenum, GLuint64 *) {}
#endif
