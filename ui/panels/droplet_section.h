// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The droplets of the chosen experiment: their list, the fields of one of them, and placing it on the fabric.
#pragma once

#include "ui/panels/design_form.h"

class QListWidget;
class QToolButton;

namespace hygroloom {

class DropletSection : public QObject {
    Q_OBJECT
public:
    /// Adds list and fields to the form.
    DropletSection(DesignForm& form, QObject* parent);

    /// The number of the droplet whose fields are shown.
    int chosen() const { return droplet_; }
    void choose(int droplet);
    void addDroplet();
    void removeDroplet();
    /// Whether a click on the fabric places the droplet.
    bool placing() const;
    /// A droplet like the chosen one. Places are mm from the sample's middle.
    void addDropletAt(const QPointF& at);
    void moveDroplet(int droplet, const QPointF& at);
    void deleteDroplet(int droplet);
    /// Moves the chosen one.
    void placeDroplet(const QPointF& at);
    void endPlacing();
    QListWidget* list() const { return list_; }

Q_SIGNALS:
    void dropletChosen();
    void placingChanged(bool placing);

private:
    void addList();
    void addFields();
    void refresh();
    const Experiment* experiment() const;
    /// Precondition: there is an experiment.
    void edit(const QString& undo, const std::function<void(Experiment&)>& change);

    DesignForm& form_;
    QListWidget* list_ = nullptr;
    QToolButton* remove_ = nullptr;
    QToolButton* place_ = nullptr;
    QLabel* none_ = nullptr;
    std::vector<QWidget*> fields_;
    int droplet_ = 0;
};

} // namespace hygroloom
