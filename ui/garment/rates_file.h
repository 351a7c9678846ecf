// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The CSV of rates over time that a wear experiment may name in place of its table of activity: choosing it, what it holds, letting it go.
#pragma once

#include "ui/garment/garment_choice.h"

#include <QFileSystemWatcher>
#include <QWidget>

class QLabel;
class QPushButton;

namespace hygroloom {

class RatesFile : public QWidget {
    Q_OBJECT
public:
    explicit RatesFile(GarmentChoice& choice, QWidget* parent = nullptr);

    /// Asks for a file.
    void choose();
    /// The table of activity holds again.
    void clear();
    /// What was read, or why it could not be.
    QString said() const;

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void read();
    void stopWatching();
    void giveRoom();
    void say(const QString& sentence, bool is_wrong);

    GarmentChoice& choice_;
    QPushButton* choose_;
    QPushButton* clear_;
    QLabel* said_;
    /// What the words are of.
    struct Source {
        std::string file;
        std::vector<OwnZone> zones;
        std::filesystem::path base;
        bool operator==(const Source&) const = default;
    };
    std::optional<Source> source_;
    QFileSystemWatcher watcher_;
    NewestJob reader_; // last: joined before the rest goes
};

} // namespace hygroloom
