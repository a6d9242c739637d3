#pragma once
// The entry points of OpenGL 3.3 core that the renderer calls. One X-macro makes the table and fills it, from
// whichever library made the context.

#include <GL/glcorearb.h>

namespace reliefbake {

#define RELIEFBAKE_GL_FUNCTIONS(X)                                                                                       \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                                                               \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                                                                   \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                                                                         \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                                                             \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                                                                 \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                                                                         \
    X(PFNGLBUFFERDATAPROC, BufferData)                                                                                   \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                                                           \
    X(PFNGLCLEARPROC, Clear)                                                                                             \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                                                             \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                                                             \
    X(PFNGLCREATESHADERPROC, CreateShader)                                                                               \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                                                             \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                                                                   \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                                                             \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                                                               \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                                                           \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                                                                   \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                                                                     \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                                                                   \
    X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                                                                 \
    X(PFNGLENABLEPROC, Enable)                                                                                           \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)                                                         \
    X(PFNGLFINISHPROC, Finish)                                                                                           \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)                                                               \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                                                                   \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                                                                         \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                                                                 \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                                                                         \
    X(PFNGLGETERRORPROC, GetError)                                                                                       \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                                                                 \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                                                                     \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                                                               \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                                                                       \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                                                                                 \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                                                                   \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                                                                 \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                                                                 \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                                                                                   \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                                                                   \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                                                               \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                                                                   \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                                                             \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                                                                                     \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                                                                                     \
    X(PFNGLUNIFORM2FPROC, Uniform2f)                                                                                     \
    X(PFNGLUNIFORM2IPROC, Uniform2i)                                                                                     \
    X(PFNGLUNIFORM3FPROC, Uniform3f)                                                                                     \
    X(PFNGLUNIFORM4FPROC, Uniform4f)                                                                                     \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                                                                   \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                                                                 \
    X(PFNGLVIEWPORTPROC, Viewport)

struct GlFunctions {
#define RELIEFBAKE_GL_DECLARE(type, name) type name = nullptr;
    RELIEFBAKE_GL_FUNCTIONS(RELIEFBAKE_GL_DECLARE)
#undef RELIEFBAKE_GL_DECLARE
};

} // namespace reliefbake
