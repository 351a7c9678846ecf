// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/camera.h"

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr double view_angle = 28;     // degrees, vertical: long enough for small distortion
constexpr double parallel_eye = 1000; // distances to the target
constexpr double degree = 3.14159265358979323846 / 180;

} // namespace

QVector3D Camera::direction() const
{
    const double c = std::cos(lift_ * degree);
    return QVector3D(static_cast<float>(c * std::sin(turn_ * degree)), static_cast<float>(-c * std::cos(turn_ * degree)),
                     static_cast<float>(std::sin(lift_ * degree)));
}

QVector3D Camera::up() const
{
    const double s = std::sin(lift_ * degree);
    return QVector3D(static_cast<float>(-s * std::sin(turn_ * degree)), static_cast<float>(s * std::cos(turn_ * degree)),
                     static_cast<float>(std::cos(lift_ * degree)));
}

QVector3D Camera::right() const { return QVector3D::crossProduct(up(), direction()); }

QVector3D Camera::eye() const { return target_ + static_cast<float>(parallel_ ? distance_ * parallel_eye : distance_) * direction(); }

QMatrix4x4 Camera::view() const
{
    QMatrix4x4 matrix;
    matrix.lookAt(target_ + static_cast<float>(distance_) * direction(), target_, up());
    return matrix;
}

QMatrix4x4 Camera::projection(const QSizeF& size) const
{
    QMatrix4x4 matrix;
    const auto aspect = static_cast<float>(size.width() / std::max(1.0, size.height()));
    if (parallel_) {
        const auto half = static_cast<float>(distance_ * std::tan(0.5 * view_angle * degree));
        const auto depth = static_cast<float>(20 * distance_ + reach_);
        matrix.ortho(-half * aspect, half * aspect, -half, half, -depth, depth);
    } else {
        matrix.perspective(view_angle, aspect, static_cast<float>(distance_ * 0.02), static_cast<float>(distance_ * 20 + reach_));
    }
    return matrix;
}

double Camera::depth(const QVector3D& point) const
{
    return parallel_ ? distance_ : distance_ - QVector3D::dotProduct(point - target_, direction());
}

double Camera::pixelsPerMillimetre(double depth, const QSizeF& size) const
{
    return size.height() / (2 * std::max(depth, 0.02 * distance_) * std::tan(0.5 * view_angle * degree));
}

double Camera::millimetrePerPixel(const QSizeF& size) const
{
    return 2 * distance_ * std::tan(0.5 * view_angle * degree) / std::max(1.0, size.height());
}

QPointF Camera::project(const QVector3D& point, const QSizeF& size) const
{
    const QVector3D clip = (projection(size) * view()).map(point);
    return {(0.5 + 0.5 * clip.x()) * size.width(), (0.5 - 0.5 * clip.y()) * size.height()};
}

Ray Camera::ray(const QPointF& at, const QSizeF& size) const
{
    const double half = std::tan(0.5 * view_angle * degree);
    const double x = (2 * at.x() / size.width() - 1) * half * size.width() / size.height();
    const double y = (1 - 2 * at.y() / size.height()) * half;
    if (parallel_) {
        const auto scale = static_cast<float>(distance_);
        return {target_ + scale * (static_cast<float>(x) * right() + static_cast<float>(y) * up()) +
                    (20 * scale + static_cast<float>(reach_)) * direction(),
                -direction()};
    }
    const QVector3D towards = static_cast<float>(x) * right() + static_cast<float>(y) * up() - direction();
    return {eye(), towards.normalized()};
}

void Camera::orbit(const QPointF& pixels, const QVector3D& pivot)
{
    const QVector3D arm = target_ - pivot;
    const QVector3D seen(QVector3D::dotProduct(arm, right()), QVector3D::dotProduct(arm, up()), QVector3D::dotProduct(arm, direction()));
    turn_ = std::remainder(turn_ - 0.4 * pixels.x(), 360);
    lift_ = std::clamp(lift_ + 0.4 * pixels.y(), -90.0, 90.0);
    target_ = pivot + seen.x() * right() + seen.y() * up() + seen.z() * direction();
}

void Camera::pan(const QPointF& pixels, const QSizeF& size)
{
    const double scale = millimetrePerPixel(size);
    target_ += static_cast<float>(-pixels.x() * scale) * right() + static_cast<float>(pixels.y() * scale) * up();
}

void Camera::zoom(double factor, const QPointF& at, const QSizeF& size)
{
    const double before = distance_;
    distance_ = std::clamp(distance_ / factor, 0.05, 20000.0);
    // The point of the target's plane under the pointer stays there.
    const Ray pointed = ray(at, size);
    if (parallel_) {
        const QVector3D arm = pointed.from - target_;
        const QVector3D across = arm - QVector3D::dotProduct(arm, direction()) * direction();
        target_ += static_cast<float>(before / distance_ - 1) * across;
        return;
    }
    const float along = QVector3D::dotProduct(pointed.direction, -direction());
    const QVector3D aside = pointed.direction / along + direction();
    target_ += static_cast<float>(before - distance_) * aside;
}

void Camera::zoomTo(double factor, const QVector3D& point)
{
    const double before = distance_;
    distance_ = std::clamp(distance_ / factor, 0.05, 20000.0);
    target_ = point + static_cast<float>(distance_ / before) * (target_ - point);
}

void Camera::zoomInSight(double factor, const QVector3D& point, const QSizeF& size)
{
    constexpr double rim = 0.05; // of the picture
    zoomTo(factor, point);
    const double away = depth(point);
    if (away < 0.02 * distance_) { // beside or behind the eye, so that it has no place in the picture
        target_ = point;
        return;
    }
    const QPointF at = project(point, size);
    const QPointF seen(std::clamp(at.x(), rim * size.width(), (1 - rim) * size.width()),
                       std::clamp(at.y(), rim * size.height(), (1 - rim) * size.height()));
    if (seen != at) { pan(away / distance_ * (seen - at), size); }
}

void Camera::fit(const QVector3D& low, const QVector3D& high, const QSizeF& size)
{
    target_ = 0.5F * (low + high);
    const double half = std::tan(0.5 * view_angle * degree);
    const double aspect = size.width() / std::max(1.0, size.height());
    double needed = 0.1;
    for (int corner = 0; corner < 8; ++corner) {
        const QVector3D at(corner & 1 ? high.x() : low.x(), corner & 2 ? high.y() : low.y(), corner & 4 ? high.z() : low.z());
        const QVector3D offset = at - target_;
        const double near = parallel_ ? 0 : QVector3D::dotProduct(offset, direction());
        needed = std::max({needed, near + std::abs(QVector3D::dotProduct(offset, right())) / (half * aspect),
                           near + std::abs(QVector3D::dotProduct(offset, up())) / half});
    }
    distance_ = 1.08 * needed;
}

void Camera::aimAt(const QVector3D& point)
{
    if (!parallel_) { distance_ = std::max(0.05, depth(point)); }
    target_ = point;
}

void Camera::showFace()
{
    constexpr double enough = 36; // degrees; at less the far cloth would have another scale
    if (looksAlong()) { lift_ = lift_ < 0 ? -enough : enough; }
}

void Camera::lookFrom(double turn, double lift)
{
    turn_ = turn;
    lift_ = lift;
}

} // namespace hygroloom
