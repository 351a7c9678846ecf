// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Which garment and which experiment on it are chosen, and the garment's pattern, read beside the window.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/document/document.h"
#include "ui/garment/garment_drawing.h"

namespace hygroloom {

class GarmentChoice : public QObject {
    Q_OBJECT
public:
    explicit GarmentChoice(Document& document, QObject* parent = nullptr);

    Document& document() const { return document_; }
    /// nullptr: the project has none.
    const Garment* garment() const;
    const WearExperiment* wear() const;
    int garmentIndex() const { return garment_; }
    int wearIndex() const { return wear_; } ///< -1: there is none on this garment
    void setGarmentIndex(int index);
    void setWearIndex(int index);
    /// Places of the experiments on the chosen garment.
    std::vector<int> wearsOfGarment() const;

    /// nullptr while the pattern is being read, or could not be.
    const std::shared_ptr<const GarmentDrawing>& drawing() const { return drawing_; }
    bool reading() const { return reading_; }
    /// Why the pattern could not be read.
    const QString& problem() const { return problem_; }
    /// The folder that sources are relative to.
    std::filesystem::path base() const;

Q_SIGNALS:
    /// The design, or what is chosen in it.
    void changed();
    /// The user has chosen a garment, be it the same again.
    void garmentChosen();
    void drawingChanged();

private:
    void refresh();
    void read();

    Document& document_;
    int garment_ = 0, wear_ = -1;
    std::shared_ptr<const GarmentDrawing> drawing_;
    bool reading_ = false;
    QString problem_;
    /// What the drawing was read from.
    struct Source {
        std::string source;
        BuiltInGarment built_in;
        UvUnit unit{};
        std::filesystem::path base;
        bool operator==(const Source&) const = default;
    };
    std::optional<Source> source_;
    NewestJob reader_;
};

} // namespace hygroloom
