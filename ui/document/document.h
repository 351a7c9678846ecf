// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The open project: its design, its undo history, its file, and what is known about it.
#pragma once

#include "core/design/validate.h"
#include "ui/document/edit_design.h"

#include <QObject>
#include <QUndoStack>

#include <functional>

namespace hygroloom {

/// Empty where no file can be read.
QByteArray hashOfFile(const QString& path);

class Document : public QObject {
    Q_OBJECT
public:
    explicit Document(QObject* parent = nullptr);

    const std::shared_ptr<const Design>& design() const { return state_.design; }
    int fabricIndex() const { return state_.fabric; }
    int experimentIndex() const { return state_.experiment; }
    /// nullptr when the project has none.
    const Fabric* fabric() const;
    const Experiment* experiment() const;
    void setFabricIndex(int index);
    void setExperimentIndex(int index);

    /// What validate() says about the design as it is now.
    const std::vector<Issue>& issues() const { return issues_; }
    bool hasError() const;
    /// Whether the chosen fabric's description has an error, so that it cannot be drawn.
    bool fabricHasError() const;
    /// Sentences about the value at this path, or about the pair it belongs to, worst first; empty when all is well.
    std::vector<const Issue*> issuesAt(const std::string& where) const;
    /// Derived numbers of the chosen fabric; nullptr while it has an error.
    const FabricQuantities* quantities() const { return fitted_ ? &fitted_->derived : nullptr; }
    /// The chosen fabric with its yarns fitted; nullptr while it has an error.
    const std::shared_ptr<const FittedFabric>& fitted() const { return fitted_; }

    /// Changes the design as one step of the history. Steps with the same field merge until endStroke().
    void edit(const QString& text, const std::string& field, const std::function<void(Design&)>& change);
    /// The same for edits that also choose another fabric or experiment.
    void editState(const QString& text, const std::function<void(Design&, DesignState&)>& change);
    void endStroke() { ++stroke_; }

    QUndoStack* history() { return &history_; }
    bool modified() const { return !history_.isClean(); }

    /// Empty until the project has a file of its own.
    const QString& path() const { return path_; }
    /// Of the project's file, from which the design names files; empty until it has one.
    QString folder() const;
    /// For the window's title: the file's name, or the example's.
    QString title() const;

    /// Each returns false after failed() gave the reason; the document is then unchanged.
    bool open(const QString& path);
    /// Opens a copy: saving opens a file dialog.
    bool openExample(const QString& path);
    /// Opens recovered work of a project at origin. Saving writes to path, or opens a file dialog when path is empty.
    bool openUnsaved(const QString& file, const QString& path, const QString& title, const QString& origin = {});
    bool save();
    /// Whether another program changed the project's file after it was opened or saved here. Reads the file.
    bool changedOnDisk() const;
    /// Of the project's file as it was opened or saved here; empty without one.
    const QByteArray& savedHash() const { return saved_; }
    /// The files that the design names from the project's folder are named from the new one, in every step of the history.
    bool saveAs(const QString& path);
    /// Takes over a design that comes from somewhere else, such as a recording.
    void take(const Design& design, const QString& title);

Q_SIGNALS:
    /// The design, or which fabric or experiment is chosen.
    void designChanged();
    void pathChanged();
    /// Another project has taken the place of the one before; pathChanged() follows.
    void replaced();
    void modifiedChanged(bool modified);
    void failed(const QString& sentence);

private:
    void apply(DesignState state);
    EditDesign* step(const QString& text, DesignState after, const std::string& field);
    void replace(Design design, const QString& path, const QString& title);

    DesignState state_;
    std::vector<Issue> issues_;
    std::shared_ptr<const FittedFabric> fitted_;
    QUndoStack history_;
    int stroke_ = 0;
    QString path_;
    QString title_;
    QByteArray saved_; ///< hash
};

} // namespace hygroloom
