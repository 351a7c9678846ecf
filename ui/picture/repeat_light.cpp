// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/repeat_light.h"

namespace hygroloom {

QString RepeatLight::initialize(QOpenGLFunctions_3_3_Core* gl)
{
    gl_ = gl;
    nothing_.create();
    unsigned textures[3];
    gl_->glGenTextures(3, textures);
    normals_ = textures[0];
    looks_ = textures[1];
    light_ = textures[2];
    gl_->glGenFramebuffers(1, &target_);
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, normals_);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, looks_);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_->glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    gl_->glBindTexture(GL_TEXTURE_2D, light_);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl_->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_->glBindTexture(GL_TEXTURE_2D, 0);
    return loadShaders(program_, "repeat");
}

void RepeatLight::release()
{
    nothing_.destroy();
    program_.removeAllShaders();
    if (gl_ && light_) {
        const unsigned textures[] = {normals_, looks_, light_};
        gl_->glDeleteTextures(3, textures);
        gl_->glDeleteFramebuffers(1, &target_);
        light_ = 0;
    }
}

void RepeatLight::setPicture(const RepeatPicture& picture)
{
    constexpr int n = RepeatPicture::looks_each_way;
    gl_->glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, normals_);
    gl_->glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA8, picture.width, picture.height, RepeatPicture::layers, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      picture.texels.data());
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, looks_);
    gl_->glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32F, n, n, 4, 0, GL_RGBA, GL_FLOAT, &picture.looks);
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    gl_->glBindTexture(GL_TEXTURE_2D, light_);
    gl_->glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, picture.width, picture.height, 0, GL_RGBA, GL_FLOAT, nullptr);
    gl_->glBindTexture(GL_TEXTURE_2D, 0);
    wound_ = {picture.wound[0], picture.wound[1]};
    size_ = {picture.width, picture.height};
    lit_from_ = {};
}

void RepeatLight::lightFrom(const QVector3D& to_eye)
{
    if (size_.isEmpty() || QVector3D::dotProduct(to_eye, lit_from_) > 0.99999F) { return; }
    lit_from_ = to_eye;
    int target = 0, viewport[4];
    gl_->glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    gl_->glGetIntegerv(GL_VIEWPORT, viewport);
    gl_->glBindFramebuffer(GL_FRAMEBUFFER, target_);
    gl_->glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, light_, 0);
    gl_->glViewport(0, 0, size_.width(), size_.height());
    gl_->glDisable(GL_DEPTH_TEST);
    gl_->glDisable(GL_BLEND);
    gl_->glActiveTexture(GL_TEXTURE0);
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, normals_);
    program_.bind();
    program_.setUniformValue("repeat_picture", 0);
    program_.setUniformValue("to_eye", to_eye);
    program_.setUniformValue("wound", wound_);
    program_.setUniformValue("side", to_eye.z() >= 0 ? 1.0F : -1.0F);
    nothing_.bind();
    gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    nothing_.release();
    program_.release();
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    gl_->glBindFramebuffer(GL_FRAMEBUFFER, static_cast<unsigned>(target));
    gl_->glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    gl_->glEnable(GL_DEPTH_TEST);
    gl_->glBindTexture(GL_TEXTURE_2D, light_);
    gl_->glGenerateMipmap(GL_TEXTURE_2D);
    gl_->glBindTexture(GL_TEXTURE_2D, 0);
}

void RepeatLight::bind(unsigned light_unit, unsigned looks_unit)
{
    gl_->glActiveTexture(GL_TEXTURE0 + light_unit);
    gl_->glBindTexture(GL_TEXTURE_2D, light_);
    gl_->glActiveTexture(GL_TEXTURE0 + looks_unit);
    gl_->glBindTexture(GL_TEXTURE_2D_ARRAY, looks_);
    gl_->glActiveTexture(GL_TEXTURE0);
}

} // namespace hygroloom
