// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The card of the chosen fabric as PDF or web page; its pictures are drawn in the background.
#pragma once

#include "core/analysis/card.h"
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
    /// Asks where; nothing where another card is being written. The card is of the chosen fabric, which has no error.
    void save(const std::shared_ptr<const Card>& card);
    void write(const QString& file, const std::shared_ptr<const Card>& card);
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
