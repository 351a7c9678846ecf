// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Numbers of technical cards as columns of a comparison: which are chosen, from a menu, and those of each fabric of the project, computed
// in the background.
#pragma once

#include "core/analysis/comparison.h"
#include "core/design/design.h"
#include "ui/basics/newest_job.h"

#include <QSet>

class QMenu;
class QPushButton;

namespace hygroloom {

class Document;

class CardColumns : public QObject {
    Q_OBJECT
public:
    /// The document must outlive it. The button gets the menu.
    CardColumns(Document& document, QPushButton* button, QObject* parent = nullptr);

    /// The chosen numbers of the fabrics whose cards are known; those of the others are computed meanwhile.
    void addTo(Comparison& comparison);
    /// Keys of the chosen numbers; kept between sessions.
    QSet<QString> chosen() const { return chosen_; }
    void choose(const QString& key, bool on);
    bool computing() const { return job_.busy(); }

Q_SIGNALS:
    void changed();

private:
    bool isKnown(const std::string& fabric) const;
    void compute();
    void fillMenu();

    struct Kept {
        std::vector<Material> materials;
        Fabric fabric;
        LaboratoryNumbers numbers;
    };
    Document& document_;
    QMenu* menu_;
    QSet<QString> chosen_;
    std::map<std::string, Kept> kept_;       ///< by the fabric's name
    std::shared_ptr<const Design> computed_; ///< or being computed
    NewestJob job_;
};

} // namespace hygroloom
