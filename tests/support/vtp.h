// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reads the files that are written for VTK's programs.
#pragma once

#include <QFile>
#include <QXmlStreamReader>

#include <cstring>
#include <map>
#include <vector>

namespace hygroloom {

/// The contents of a .vtp: its arrays' bytes by name, and the counts of its piece.
struct Vtp {
    std::map<QString, QByteArray> arrays;
    std::map<QString, int> count;

    explicit Vtp(const QString& path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly)) return;
        const QByteArray bytes = file.readAll();
        const auto data = bytes.indexOf("\n_") + 2;
        QXmlStreamReader xml(bytes.left(bytes.indexOf("<AppendedData")) + "</VTKFile>");
        while (!xml.atEnd()) {
            xml.readNext();
            if (!xml.isStartElement()) continue;
            const QXmlStreamAttributes about = xml.attributes();
            if (xml.name() == QStringLiteral("Piece"))
                for (const char* what : {"NumberOfPoints", "NumberOfLines", "NumberOfVerts", "NumberOfPolys"})
                    count[what] = about.value(what).toInt();
            if (!about.hasAttribute("offset")) continue;
            const auto at = data + about.value("offset").toLongLong();
            std::uint64_t size = 0;
            std::memcpy(&size, bytes.constData() + at, sizeof size);
            arrays[about.value("Name").toString()] = bytes.mid(at + 8, static_cast<qsizetype>(size));
        }
        well_formed = !xml.hasError();
    }
    template <typename T> std::vector<T> values(const char* name) const
    {
        const QByteArray bytes = arrays.at(name);
        std::vector<T> list(static_cast<std::size_t>(bytes.size()) / sizeof(T));
        std::memcpy(list.data(), bytes.constData(), list.size() * sizeof(T));
        return list;
    }
    bool well_formed = false;
};

} // namespace hygroloom
