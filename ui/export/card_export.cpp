// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/export/card_export.h"

#include "core/base/error.h"
#include "ui/results/report_file.h"

#include <QFileInfo>
#include <QStandardPaths>

namespace hygroloom {

CardExport::CardExport(Document& document, QWidget* window) : QObject(window), document_(document), window_(window) {}

void CardExport::save(const std::shared_ptr<const Card>& card)
{
    if (busy()) {
        Q_EMIT failed(tr("Another card is still being written. Save this one when that is done."));
        return;
    }
    const QString folder = document_.path().isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                                      : QFileInfo(document_.path()).absolutePath();
    const QString file =
        askForReportFile(window_, folder, tr("%1, card").arg(QString::fromStdString(document_.fabric()->name)), tr("Save Card"));
    if (!file.isEmpty()) { write(file, card); }
}

void CardExport::write(const QString& file, const std::shared_ptr<const Card>& card)
{
    Q_EMIT making(tr("Making the card."));
    job_.run([this, file, card, design = document_.design(), fabric = *document_.fabric(),
              fitted = document_.fitted()](const NewestJob::Turn& turn) {
        std::vector<ReportPicture> pictures;
        QString why;
        try {
            pictures = card_pictures(*design, fabric, *fitted);
        } catch (const std::exception& error) {
            why = QString::fromUtf8(error.what());
        }
        turn.deliver([this, file, card, pictures, why] {
            try {
                if (!why.isEmpty()) { throw Error(why.toStdString()); }
                writeReport(card_page(*card, pictures, unitsOfReader()), file);
                Q_EMIT written(tr("Saved %1.").arg(file));
            } catch (const std::exception& error) {
                Q_EMIT failed(QString::fromUtf8(error.what()));
            }
        });
    });
}

} // namespace hygroloom
