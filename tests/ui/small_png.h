// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// PNG files that stay small because they have few colours.
#pragma once

#include <QBuffer>
#include <QImage>

#include <algorithm>
#include <map>
#include <vector>

/// A colour of a picture, and the number of pixels that have it.
struct ColorCount {
    QRgb color;
    long pixels;
};
using ColorBox = std::vector<ColorCount>;

inline int channel(QRgb color, int number) { return number == 0 ? qRed(color) : number == 1 ? qGreen(color) : qBlue(color); }

/// The channel in which the box is widest, and how wide it is there.
inline std::pair<int, int> widest(const ColorBox& box)
{
    std::pair<int, int> found{0, -1};
    for (int number = 0; number < 3; ++number) {
        const auto less = [number](const ColorCount& a, const ColorCount& b) {
            return channel(a.color, number) < channel(b.color, number);
        };
        const auto [low, high] = std::minmax_element(box.begin(), box.end(), less);
        const int width = channel(high->color, number) - channel(low->color, number);
        if (width > found.second) { found = {number, width}; }
    }
    return found;
}

/// Halves the widest box until there are enough (median cut: Heckbert, SIGGRAPH 1982).
inline std::vector<ColorBox> boxesOf(ColorBox all, std::size_t count)
{
    std::vector<ColorBox> boxes{std::move(all)};
    while (boxes.size() < count) {
        const auto less = [](const ColorBox& a, const ColorBox& b) { return widest(a).second < widest(b).second; };
        const auto box = std::max_element(boxes.begin(), boxes.end(), less);
        const auto [number, width] = widest(*box);
        if (width == 0) { break; }
        std::sort(box->begin(), box->end(),
                  [n = number](const ColorCount& a, const ColorCount& b) { return channel(a.color, n) < channel(b.color, n); });
        const auto middle = box->begin() + static_cast<std::ptrdiff_t>(box->size() / 2);
        ColorBox upper(middle, box->end());
        box->erase(middle, box->end());
        boxes.push_back(std::move(upper));
    }
    return boxes;
}

/// The picture with at most this number of colours, of which the most frequent ones, those of flat areas, stay exact.
inline QImage withColors(const QImage& picture, std::size_t count)
{
    std::map<QRgb, long> pixels;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) { ++pixels[picture.pixel(x, y)]; }
    }
    ColorBox all;
    for (const auto& [color, number] : pixels) { all.push_back({color, number}); }
    std::sort(all.begin(), all.end(), [](const ColorCount& a, const ColorCount& b) { return a.pixels > b.pixels; });
    const std::size_t exact = std::min(all.size(), count / 4);
    std::vector<ColorBox> boxes = exact < all.size() ? boxesOf({all.begin() + static_cast<std::ptrdiff_t>(exact), all.end()}, count - exact)
                                                     : std::vector<ColorBox>();
    for (std::size_t i = 0; i < exact; ++i) { boxes.push_back({all[i]}); }
    std::map<QRgb, unsigned> index;
    QList<QRgb> table;
    for (const ColorBox& box : boxes) {
        long sum[3] = {}, number = 0;
        for (const ColorCount& one : box) {
            for (int k = 0; k < 3; ++k) { sum[k] += one.pixels * channel(one.color, k); }
            number += one.pixels;
            index[one.color] = static_cast<unsigned>(table.size());
        }
        table << qRgb(static_cast<int>(sum[0] / number), static_cast<int>(sum[1] / number), static_cast<int>(sum[2] / number));
    }
    QImage made(picture.size(), QImage::Format_Indexed8);
    made.setColorTable(table);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) { made.setPixel(x, y, index[picture.pixel(x, y)]); }
    }
    return made;
}

/// A PNG file with as many colours as this number of bytes allows; 16 at least.
inline QByteArray smallPng(const QImage& picture, int most_bytes)
{
    QByteArray bytes;
    for (std::size_t colors = 256; colors >= 16; colors /= 2) {
        bytes.clear();
        QBuffer buffer(&bytes);
        withColors(picture, colors).save(&buffer, "PNG", 0);
        if (bytes.size() < most_bytes) { break; }
    }
    return bytes;
}
