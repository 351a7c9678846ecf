// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Where the fabric is looked at from. Lengths in millimetres; z points out of the fabric's top face.
#pragma once

#include <QMatrix4x4>
#include <QPointF>
#include <QSizeF>
#include <QVector3D>

#include <cmath>

namespace hygroloom {

struct Ray {
    QVector3D from;
    QVector3D direction; ///< unit
};

/// Turns round a target point: the turntable of modelling programs.
class Camera {
public:
    QMatrix4x4 view() const;
    QMatrix4x4 projection(const QSizeF& size) const;
    /// Far away in a parallel view, so that all lines of sight run alike.
    QVector3D eye() const;
    QVector3D target() const { return target_; }
    /// Unit, from the target to the eye.
    QVector3D direction() const;
    bool parallel() const { return parallel_; }
    void setParallel(bool parallel) { parallel_ = parallel; }
    /// Length on the target's plane that one pixel covers.
    double millimetrePerPixel(const QSizeF& size) const;
    /// Pixels that a millimetre across the line of sight covers at a depth along it, measured from the eye.
    double pixelsPerMillimetre(double depth, const QSizeF& size) const;
    /// Distance from the eye's plane, along the line of sight; in a parallel view the target's, wherever the point is.
    double depth(const QVector3D& point) const;
    /// How far the scene reaches beyond the target; what lies farther may be cut off.
    void setReach(double millimetre) { reach_ = millimetre; }

    /// Where a point is in the picture, and the ray under a point of the picture.
    QPointF project(const QVector3D& point, const QSizeF& size) const;
    Ray ray(const QPointF& at, const QSizeF& size) const;

    /// Turns round a point, which stays where it is in the picture.
    void orbit(const QPointF& pixels, const QVector3D& pivot);
    void pan(const QPointF& pixels, const QSizeF& size);
    /// Keeps the point under the pointer where it is. factor > 1 comes nearer.
    void zoom(double factor, const QPointF& at, const QSizeF& size);
    /// Towards a point, which stays where it is in the picture and is never passed.
    void zoomTo(double factor, const QVector3D& point);
    /// The same, and a point that lies beside the picture comes into it.
    void zoomInSight(double factor, const QVector3D& point, const QSizeF& size);
    /// At a point in the middle of the picture, which stays as it is.
    void aimAt(const QVector3D& point);
    void centreOn(const QVector3D& point) { target_ = point; }
    /// Shows the whole box, from the same direction.
    void fit(const QVector3D& low, const QVector3D& high, const QSizeF& size);
    /// Degrees: turn 0 looks along +y, lift 90 looks down on the fabric.
    void lookFrom(double turn, double lift);
    /// Whether the fabric is looked at from its edge, so that a face of it is hardly seen.
    bool looksAlong() const { return std::abs(direction().z()) < 0.2F; }
    /// Turns up to where a face is seen, if it is not.
    void showFace();
    bool operator==(const Camera&) const = default;

private:
    QVector3D up() const;
    QVector3D right() const;

    QVector3D target_;
    double distance_ = 20;
    double turn_ = -28;
    double lift_ = 48;
    double reach_ = 0;
    bool parallel_ = false;
};

} // namespace hygroloom
