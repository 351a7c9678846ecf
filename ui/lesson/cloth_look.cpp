// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/cloth_look.h"

#include "core/project/wet_look.h"
#include "ui/weave/cloth_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hygroloom {

namespace {

/// sRGB, 0 .. 255, as a share of light, and back.
double lightOf(int value)
{
    const double v = value / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}
int valueOf(double light)
{
    const double v = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
    return std::clamp(qRound(255 * v), 0, 255);
}

/// The same from tables: a picture has many pixels.
class Lights {
public:
    Lights()
    {
        for (int value = 0; value < 256; ++value) { light_[static_cast<std::size_t>(value)] = lightOf(value); }
        for (std::size_t k = 0; k < value_.size(); ++k) {
            value_[k] = valueOf(static_cast<double>(k) / static_cast<double>(value_.size() - 1));
        }
    }
    int shaded(int value, double light) const
    {
        const double share = std::clamp(light_[static_cast<std::size_t>(value)] * light, 0.0, 1.0);
        return value_[static_cast<std::size_t>(share * static_cast<double>(value_.size() - 1))];
    }

private:
    std::array<double, 256> light_{};
    std::array<int, 16384> value_{};
};

/// How much light a yarn that lies on top sends up, at a place of its crossing from -1 to 1 across it and along it: round across, and a
/// little bent down to where it goes under.
double shade(double across, double along) { return 1 - 0.42 * across * across - 0.16 * along * along; }

/// Mean of some places of the pixel, so that fine weaves do not flicker.
double shadeOfPixel(bool warp_up, double x, double y, double step)
{
    constexpr int places = 3;
    double sum = 0;
    for (int i = 0; i < places; ++i) {
        for (int k = 0; k < places; ++k) {
            const double u = x + step * (i + 0.5) / places, v = y + step * (k + 0.5) / places; // in threads
            const double across = 2 * (u - std::floor(u)) - 1, along = 2 * (v - std::floor(v)) - 1;
            sum += warp_up ? shade(across, along) : shade(along, across);
        }
    }
    return sum / (places * places);
}

} // namespace

std::vector<float> wetShares(const Textile& textile, const Frame& frame)
{
    std::vector<float> shares(static_cast<std::size_t>(textile.crossings()));
    std::size_t i = 0;
    for (int end = 0; end < textile.ends(); ++end) {
        for (int pick = 0; pick < textile.picks(); ++pick, ++i) {
            const YarnKind top = textile.warp_up(end, pick) ? YarnKind::warp : YarnKind::weft;
            shares[i] = std::clamp(frame.saturation[static_cast<std::size_t>(textile.segment(top, end, pick))], 0.0F, 1.0F);
        }
    }
    return shares;
}

ClothLook::ClothLook(const Fabric& fabric, const Textile& textile, int side)
    : dry_(side, side, QImage::Format_RGB32), wet_(side, side, QImage::Format_RGB32), now_(side, side, QImage::Format_RGB32)
{
    const int ends = textile.ends(), picks = textile.picks();
    const QImage colors = clothPicture(fabric, ends, picks);
    static const Lights lights;
    std::array<int, 256> wet{};
    for (int value = 0; value < 256; ++value) { wet[static_cast<std::size_t>(value)] = valueOf(wet_reflectance(lightOf(value))); }
    for (int k = 0; k < side; ++k) {
        end_of_.push_back(std::min(ends - 1, k * ends / side));
        pick_of_.push_back(std::min(picks - 1, (side - 1 - k) * picks / side));
    }
    const double across = static_cast<double>(ends) / side, up = static_cast<double>(picks) / side;
    for (int row = 0; row < side; ++row) {
        auto* dry_line = reinterpret_cast<QRgb*>(dry_.scanLine(row));
        auto* wet_line = reinterpret_cast<QRgb*>(wet_.scanLine(row));
        const int pick = pick_of_[static_cast<std::size_t>(row)];
        for (int column = 0; column < side; ++column) {
            const int end = end_of_[static_cast<std::size_t>(column)];
            const double light = shadeOfPixel(textile.warp_up(end, pick), column * across, (side - 1 - row) * up, std::max(across, up));
            const QRgb color = colors.pixel(end, picks - 1 - pick);
            const auto shaded = [&, light](int value) { return lights.shaded(value, light); };
            dry_line[column] = qRgb(shaded(qRed(color)), shaded(qGreen(color)), shaded(qBlue(color)));
            const auto darker = [&wet](int value) { return wet[static_cast<std::size_t>(value)]; };
            wet_line[column] = qRgb(darker(qRed(dry_line[column])), darker(qGreen(dry_line[column])), darker(qBlue(dry_line[column])));
        }
    }
}

const QImage& ClothLook::at(const Textile& textile, const Frame& frame)
{
    const std::vector<float> shares = wetShares(textile, frame);
    const auto picks = static_cast<std::size_t>(textile.picks());
    for (int row = 0; row < side(); ++row) {
        const auto* dry = reinterpret_cast<const QRgb*>(dry_.constScanLine(row));
        const auto* wet = reinterpret_cast<const QRgb*>(wet_.constScanLine(row));
        auto* line = reinterpret_cast<QRgb*>(now_.scanLine(row));
        const auto pick = static_cast<std::size_t>(pick_of_[static_cast<std::size_t>(row)]);
        for (int column = 0; column < side(); ++column) {
            const auto end = static_cast<std::size_t>(end_of_[static_cast<std::size_t>(column)]);
            const auto share = static_cast<unsigned>(255.0F * shares[end * picks + pick]);
            if (share == 0) {
                line[column] = dry[column];
                continue;
            }
            const auto between = [share](int a, int b) { return a + (b - a) * static_cast<int>(share) / 255; };
            const QRgb a = dry[column], b = wet[column];
            line[column] = qRgb(between(qRed(a), qRed(b)), between(qGreen(a), qGreen(b)), between(qBlue(a), qBlue(b)));
        }
    }
    return now_;
}

} // namespace hygroloom
