// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/sample_sum.h"

#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

#include <cmath>

namespace hygroloom {

QString SampleSum::initialize()
{
    gl_ = QOpenGLVersionFunctionsFactory::get<QOpenGLFunctions_3_3_Core>(QOpenGLContext::currentContext());
    nothing_.create();
    return loadShaders(program_, "copy");
}

void SampleSum::release()
{
    sample_.reset();
    sum_.reset();
    nothing_.destroy();
    program_.removeAllShaders();
}

void SampleSum::begin(const QSize& pixels)
{
    count_ = 0;
    if (sum_ && sum_->size() == pixels) { return; }
    sample_ = lightPicture(pixels);
    sum_ = lightCopy(pixels);
}

void SampleSum::add()
{
    ++count_;
    sum_->bind();
    gl_->glViewport(0, 0, sum_->width(), sum_->height());
    gl_->glDisable(GL_DEPTH_TEST);
    gl_->glEnable(GL_BLEND);
    gl_->glBlendColor(0, 0, 0, 1.0F / static_cast<float>(count_));
    gl_->glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    gl_->glActiveTexture(GL_TEXTURE0);
    gl_->glBindTexture(GL_TEXTURE_2D, sample_->texture());
    program_.bind();
    program_.setUniformValue("picture", 0);
    nothing_.bind();
    gl_->glDrawArrays(GL_TRIANGLES, 0, 3);
    nothing_.release();
    program_.release();
    gl_->glBindTexture(GL_TEXTURE_2D, 0);
    gl_->glDisable(GL_BLEND);
    sum_->release();
}

/// By the powers of 1 / 1.3247..., whose cube is itself and one: any number of places lies evenly.
QPointF SampleSum::nextShift() const
{
    const double u = 0.7548776662466927 * count_, v = 0.5698402909980532 * count_;
    return {u - std::round(u), v - std::round(v)};
}

} // namespace hygroloom
