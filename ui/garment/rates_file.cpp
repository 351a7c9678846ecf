// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/rates_file.h"

#include "core/garment/sweat_table.h"
#include "ui/basics/appearance.h"
#include "ui/basics/core_words.h"
#include "ui/basics/quantity.h"
#include "ui/document/sources.h"
#include "ui/garment/garment_edits.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr QChar line_end(0x200b); // without width: where a line of a long path may end

/// Rows, zones and span.
QString wordsOf(const SweatCourse& course)
{
    QStringList zones;
    for (const std::string& zone : course.named) { zones << coreWord(zone); }
    const QString skin = course.has_temperature ? RatesFile::tr("with skin temperatures") : RatesFile::tr("without skin temperatures");
    return RatesFile::tr("%1 rows from %2 to %3 s, %4. Zones: %5.")
        .arg(course.rows)
        .arg(shownNumber(course.first_time, 3), shownNumber(course.last_time, 3), skin, zones.join(", "));
}

} // namespace

RatesFile::RatesFile(GarmentChoice& choice, QWidget* parent)
    : QWidget(parent), choice_(choice), choose_(new QPushButton), clear_(new QPushButton(tr("Use the Table"))), said_(new QLabel)
{
    choose_->setToolTip(tr("Take the zones' rates over time from a CSV with the columns time_s, zone, g_m2_h and, if you have them, "
                           "skin_temperature_c."));
    clear_->setToolTip(tr("Leave the file, and let the wearer sweat as the table of activity says."));
    said_->setWordWrap(true);
    said_->setTextFormat(Qt::PlainText);                            // names of files
    said_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // a path may be wider than the form
    said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    said_->setAccessibleName(tr("What the file of rates holds"));
    connect(choose_, &QPushButton::clicked, this, &RatesFile::choose);
    connect(clear_, &QPushButton::clicked, this, &RatesFile::clear);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(choose_, 1);
    row->addWidget(clear_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(said_);
    connect(&choice_, &GarmentChoice::changed, this, &RatesFile::refresh);
    connect(&watcher_, &QFileSystemWatcher::fileChanged, this, &RatesFile::read);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, this, &RatesFile::read);
    refresh();
}

void RatesFile::choose()
{
    if (!choice_.wear()) { return; }
    const QString folder = choice_.document().folder();
    const QString file = QFileDialog::getOpenFileName(this, tr("Rates over Time"), folder, tr("Tables of rates (*.csv)"));
    if (file.isEmpty()) { return; }
    editWear(choice_.document(), tr("choose rates over time"), choice_.wearIndex(), {},
             [&](WearExperiment& wear) { wear.activity_file = sourceFrom(folder, file).toStdString(); });
}

void RatesFile::clear()
{
    editWear(choice_.document(), tr("leave rates over time"), choice_.wearIndex(), {},
             [](WearExperiment& wear) { wear.activity_file.clear(); });
}

QString RatesFile::said() const { return said_->text().remove(line_end); }

void RatesFile::say(const QString& sentence, bool is_wrong)
{
    QPalette colors = palette();
    if (is_wrong) { colors.setColor(QPalette::WindowText, severityColor(Severity::error, colors)); }
    said_->setPalette(colors);
    said_->setText(QString(sentence).replace("/", "/" + QString(line_end)));
    giveRoom();
}

/// A scroll area asks nobody for a height that follows from the width.
void RatesFile::giveRoom() { said_->setFixedHeight(std::max(said_->fontMetrics().lineSpacing(), said_->heightForWidth(width()))); }

void RatesFile::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    giveRoom();
}

void RatesFile::refresh()
{
    const WearExperiment* wear = choice_.wear();
    const bool any = wear && !wear->activity_file.empty();
    choose_->setEnabled(wear != nullptr);
    choose_->setText(any ? tr("Another CSV File…") : tr("From a CSV File…"));
    clear_->setVisible(any);
    said_->setVisible(any);
    if (!any) {
        source_.reset();
        reader_.drop();
        said_->clear();
        stopWatching();
        return;
    }
    const Source source{wear->activity_file, choice_.garment() ? choice_.garment()->wearer.own_zones : std::vector<OwnZone>{},
                        choice_.base()};
    if (source_ == source) { return; }
    source_ = source;
    read();
}

void RatesFile::stopWatching()
{
    const QStringList watched = watcher_.files() + watcher_.directories();
    if (!watched.isEmpty()) { watcher_.removePaths(watched); }
}

/// Also when another program has written the file.
void RatesFile::read()
{
    if (!source_) { return; }
    stopWatching();
    const QString path = QString::fromStdString((source_->base / source_->file).string());
    for (const QString& watched : {path, QFileInfo(path).absolutePath()}) { // the folder until the file is there
        if (QFileInfo::exists(watched)) {
            watcher_.addPath(watched);
            break;
        }
    }
    reader_.run([this, source = *source_](const NewestJob::Turn& turn) {
        QString words;
        bool is_wrong = false;
        try {
            words = wordsOf(sweat_course(source.file, source.base, source.zones));
        } catch (const std::exception& error) {
            words = QString::fromUtf8(error.what());
            is_wrong = true;
        }
        turn.deliver([this, source, words, is_wrong] {
            if (source_ == source) { say(words, is_wrong); }
        });
    });
}

} // namespace hygroloom
