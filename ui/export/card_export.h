// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// File, Technical Card: the chosen fabric's card as PDF or web page, computed in the background.
#pragma once

#include "ui/basics/newest_job.h"
#include "ui/document/document.h"

#include <QPointer>
#include <QWidget>

namespace hygroloom {

class CardExport : public QObject {
    Q_OBJECT
public:
    /// The document must outlive it.
    CardExport(Document& document, QWidget* window);
    /// Asks where; nothing where the fabric has an error, or another card is being written.
    void save();
    void write(const QString& file);
    bool busy() const { return job_.busy(); }

Q_SIGNALS:
    void making(const QString& sentence);
    void written(const QString& sentence);
    void failed(const QString& sentence);

private:
    Document& document_;
    QWidget* window_;
    NewestJob job_;
};

} // namespace hygroloom
