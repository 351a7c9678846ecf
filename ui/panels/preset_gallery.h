// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fabrics to begin with, as pictures to choose from: those that ship with the program, and those the user keeps.
#pragma once

#include "core/project/library.h"
#include "ui/basics/newest_job.h"

#include <QDialog>
#include <QIcon>

#include <map>

class QComboBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QOffscreenSurface;
class QPushButton;

namespace hygroloom {

/// Where the user's library lies.
QString userLibraryPath();

/// Puts a fabric into the library at path; one of the same name is replaced. Throws FileError.
void keepInLibrary(const Design& design, const Fabric& fabric, const QString& path);

class PresetGallery : public QDialog {
    Q_OBJECT
public:
    explicit PresetGallery(const QString& library, QWidget* parent = nullptr);
    ~PresetGallery() override;

    /// nullptr when none is.
    const Preset* chosen() const;
    /// Shows those of a group (empty: all) that have all these words in name, note, group or fibres.
    void search(const QString& group, const QString& words);
    /// Takes the chosen preset out of the user's library.
    void removeChosen();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void readUserLibrary();
    void fill();
    void describe();
    void paintVisible();
    void showPicture(int preset, const QImage& picture);

    QString library_;
    std::vector<Preset> presets_; ///< the shipped ones, then the user's
    std::size_t shipped_ = 0;
    QComboBox* groups_;
    QLineEdit* words_;
    QListWidget* list_;
    QLabel* about_;
    QPushButton* add_ = nullptr;
    QPushButton* remove_ = nullptr;
    QString problem_;
    std::unique_ptr<QOffscreenSurface> surface_;
    std::map<int, QIcon> pictures_; ///< by number of the preset
    NewestJob painter_;             // last: its deliveries use the rest
};

} // namespace hygroloom
