// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/report_file.h"

#include "core/analysis/svg.h"
#include "core/base/error.h"
#include "core/project/atomic_file.h"
#include "ui/basics/quantity.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFileDialog>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextObjectInterface>

#include <cmath>
#include <map>
#include <memory>
#include <set>

namespace hygroloom {
namespace {

// A page is laid out at 96 pixels an inch and drawn at the file's resolution.
constexpr double pixels_per_mm = 96 / 25.4, text_width = 174 * pixels_per_mm, text_height = 255 * pixels_per_mm;
constexpr double margin = 18 * pixels_per_mm, number_at = 265 * pixels_per_mm;

/// Pictures that scale, drawn as vectors where the text names them, and the others as they are.
class Pictures : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)
public:
    void clear() { drawings_.clear(); }
    /// The name by which the text shows the picture.
    QString add(const QByteArray& svg)
    {
        const QString name = QString("curves:%1").arg(drawings_.size());
        drawings_[name] = std::make_unique<QSvgRenderer>(svg);
        return name;
    }
    QSizeF intrinsicSize(QTextDocument* document, int, const QTextFormat& format) override
    {
        const QString name = format.toImageFormat().name();
        const auto drawing = drawings_.find(name);
        const QSizeF size = drawing != drawings_.end() ? QSizeF(drawing->second->defaultSize()) : QSizeF(image(document, name).size());
        if (const double width = format.toImageFormat().width(); width > 0) { return size * (width / size.width()); } // at true scale
        const double wide = drawing != drawings_.end() ? text_width : 0.48 * text_width; // two maps stand side by side
        return size.width() > wide ? size * (wide / size.width()) : size;
    }
    void drawObject(QPainter* painter, const QRectF& place, QTextDocument* document, int, const QTextFormat& format) override
    {
        const QString name = format.toImageFormat().name();
        if (const auto drawing = drawings_.find(name); drawing != drawings_.end())
            drawing->second->render(painter, place);
        else
            painter->drawImage(place, image(document, name));
    }

private:
    static QImage image(QTextDocument* document, const QString& name)
    {
        return qvariant_cast<QImage>(document->resource(QTextDocument::ImageResource, name));
    }
    std::map<QString, std::unique_ptr<QSvgRenderer>> drawings_;
};

/// The page in the rich text of Qt, which knows no SVG, no figures and no captions. Headings in `broken`, counted from 0, begin a page.
class RichText {
public:
    RichText(Pictures& pictures, QTextDocument& document, const std::set<int>& broken)
        : pictures_(pictures), document_(document), broken_(broken)
    {
    }
    QString of(const ReportPage& page)
    {
        heading(page.title, 1);
        for (const PageBlock& block : page.blocks) {
            const auto* picture = std::get_if<PagePicture>(&block);
            if (!picture || (picture->width_mm > 0) != true_scale_) { endPictures(); }
            if (picture) { true_scale_ = picture->width_mm > 0; }
            std::visit(*this, block);
        }
        endPictures();
        return html_;
    }

    void operator()(const PageHeading& block) { heading(block.text, block.level); }
    void operator()(const PageText& block)
    {
        html_ += "<p>" + (block.strong.empty() ? QString() : "<b>" + escaped(block.strong) + "</b> ") + escaped(block.text) + "</p>";
    }
    void operator()(const PageList& block)
    {
        html_ += "<ul>";
        for (const std::string& one : block.sentences) { html_ += "<li>" + escaped(one) + "</li>"; }
        html_ += "</ul>";
    }
    void operator()(const PageTable& block)
    {
        html_ += "<table cellspacing=\"0\" cellpadding=\"3\">";
        for (const PageRow& row : block.rows) {
            html_ += "<tr>";
            for (const PageCell& cell : row) { this->cell(cell); }
            html_ += "</tr>";
        }
        html_ += "</table>";
    }
    void operator()(const PageDrawing& block)
    {
        html_ += QString("<p><img src=\"%1\">").arg(pictures_.add(QByteArray::fromStdString(block.svg)));
        html_ += (block.caption.empty() ? QString() : "<br>" + escaped(block.caption)) + "</p>";
    }
    /// Two of those that follow each other stand in a row; those at true scale, which are small, in rows of their own.
    void operator()(const PagePicture& block)
    {
        const QString name = QString("map:%1").arg(maps_++);
        document_.addResource(QTextDocument::ImageResource, QUrl(name), QImage::fromData(QByteArray::fromStdString(block.png)));
        if (in_row_ == 0) { html_ += "<table cellspacing=\"0\" cellpadding=\"3\">"; }
        if (in_row_++ % 2 == 0) { html_ += "<tr>"; }
        const QString width = block.width_mm > 0 ? QString(" width=\"%1\"").arg(block.width_mm * pixels_per_mm) : QString();
        const QString bar = block.width_mm > 0 ? barOf10mm() : QString();
        html_ += QString("<td><img src=\"%1\"%2><br>").arg(name, width) + bar + escaped(block.caption) + "</td>";
    }

private:
    static QString escaped(const std::string& text) { return QString::fromStdString(escaped_markup(text)); }
    QString barOf10mm()
    {
        const QString name = pictures_.add("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10\" height=\"1\" viewBox=\"0 0 10 1\">"
                                           "<rect width=\"10\" height=\"1\"/></svg>");
        return QString("<img src=\"%1\" width=\"%2\"> 10 mm<br>").arg(name).arg(10 * pixels_per_mm);
    }
    void heading(const std::string& text, int level)
    {
        const char* style = broken_.contains(headings_++) ? " style=\"page-break-before: always\"" : "";
        html_ += QString("<h%1%2>%3</h%1>").arg(QString::number(level), style, escaped(text));
    }
    void cell(const PageCell& cell)
    {
        const QString tag = cell.kind == PageCell::Kind::heading ? "th" : "td";
        html_ +=
            QString("<%1%2 colspan=\"%3\">").arg(tag, cell.kind == PageCell::Kind::number ? " class=\"number\"" : "").arg(cell.columns);
        html_ += escaped(cell.text);
        for (const std::string& line : cell.strong) { html_ += "<br><b>" + escaped(line) + "</b>"; }
        html_ += (cell.below.empty() ? QString() : "<br>" + escaped(cell.below)) + QString("</%1>").arg(tag);
    }
    void endPictures()
    {
        if (in_row_ > 0) { html_ += "</table>"; }
        in_row_ = 0;
    }

    Pictures& pictures_;
    QTextDocument& document_;
    const std::set<int>& broken_;
    QString html_;
    int headings_ = 0, maps_ = 0, in_row_ = 0;
    bool true_scale_ = false; ///< the picture before
};

/// The page on which a block's first line stands.
int pageOf(const QTextDocument& document, const QTextBlock& block)
{
    const double line = block.layout()->lineCount() > 0 ? block.layout()->lineAt(0).y() : 0;
    constexpr double rounding = 1; // px
    return static_cast<int>((document.documentLayout()->blockBoundingRect(block).top() + line + rounding) / text_height);
}

/// Which heading of the document, counted from 0, stands on another page than what follows it; -1: none.
int lonelyHeading(const QTextDocument& document)
{
    int heading = 0;
    for (QTextBlock block = document.begin(); block.isValid() && block.next().isValid(); block = block.next())
        if (block.blockFormat().headingLevel() > 0) {
            if (pageOf(document, block) != pageOf(document, block.next())) return heading;
            ++heading;
        }
    return -1;
}

/// Lays the page out, each heading on the page of what follows it.
void layOut(QTextDocument& document, const ReportPage& page, Pictures& pictures)
{
    std::set<int> broken;
    for (bool changed = true; changed;) {
        pictures.clear();
        document.setHtml(RichText(pictures, document, broken).of(page));
        document.setPageSize({text_width, text_height});
        const int lonely = lonelyHeading(document);
        changed = lonely >= 0 && broken.insert(lonely).second;
    }
}

void drawPages(QTextDocument& document, QPdfWriter& writer)
{
    QPainter painter(&writer);
    const double scale = writer.logicalDpiX() / 96.0;
    for (int page = 0; page < document.pageCount(); ++page) {
        if (page > 0) writer.newPage();
        painter.save();
        painter.scale(scale, scale);
        painter.setFont(document.defaultFont());
        painter.drawText(QRectF(margin, margin + number_at - 12, text_width, 24), Qt::AlignRight,
                         QString("%1 / %2").arg(page + 1).arg(document.pageCount()));
        painter.translate(margin, margin - page * text_height);
        QAbstractTextDocumentLayout::PaintContext context;
        context.clip = QRectF(0, page * text_height, text_width, text_height);
        painter.setClipRect(context.clip);
        context.palette.setColor(QPalette::Text, Qt::black);
        document.documentLayout()->draw(&painter, context);
        painter.restore();
    }
}

} // namespace

ReaderUnits unitsOfReader()
{
    return [](const std::string& unit) {
        const UserUnit user = userUnit(QString::fromStdString(unit));
        return ReaderUnit{user.unit.toStdString(), user.per_one, user.at_zero, user.inverse};
    };
}

std::string pdfOf(const ReportPage& page)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setCreator("Hygroloom");
    writer.setPageLayout(QPageLayout(QPageSize(QPageSize::A4), QPageLayout::Portrait, QMarginsF(), QPageLayout::Millimeter));
    QTextDocument document;
    document.setUseDesignMetrics(true);
    document.setDocumentMargin(0);
    document.setDefaultFont(QFont("DejaVu Sans", 9));
    document.setDefaultStyleSheet("h1 { font-size: 16pt; } h2 { font-size: 12pt; margin-top: 14px; } h3 { font-size: 10pt; }"
                                  "pre { font-size: 7pt; } th { text-align: left; padding-right: 10px; } td.number { text-align: right; }");
    auto* pictures = new Pictures;
    pictures->setParent(&document);
    document.documentLayout()->registerHandler(QTextFormat::ImageObject, pictures);
    layOut(document, page, *pictures);
    drawPages(document, writer);
    return bytes.toStdString();
}

void writeReport(const ReportPage& page, const QString& file)
{
    const bool pdf = file.endsWith(".pdf", Qt::CaseInsensitive);
    const std::string bytes = pdf ? pdfOf(page) : written_as(page, file.toStdString());
    if (bytes.empty())
        throw Error(QObject::tr("%1: A report is a .pdf, .html, .txt or .json file. Give a name with one of these endings.")
                        .arg(file)
                        .toStdString());
    write_file(file.toStdString(), bytes);
}

QString withKnownEnding(const QString& file, const QString& usual, const FileKind& first, const FileKind& second)
{
    for (const FileKind& kind : {first, second})
        if (file.endsWith("." + kind.ending, Qt::CaseInsensitive)) return file;
    return file + "." + usual;
}

QString askForFile(QWidget* parent, const QString& title, const QString& folder, const QString& name, const FileKind& first,
                   const FileKind& second)
{
    const auto filter = [](const FileKind& kind) { return QStringLiteral("%1 (*.%2)").arg(kind.words, kind.ending); };
    QFileDialog dialog(parent, title, folder);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({filter(first), filter(second)});
    dialog.setDefaultSuffix(first.ending); // the dialog asks before it replaces a file of the whole name
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                     [&](const QString& chosen) { dialog.setDefaultSuffix((chosen == filter(second) ? second : first).ending); });
    dialog.selectFile(QString(name).replace('/', '-') + "." + first.ending);
    while (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty()) {
        const QString chosen = dialog.selectedFiles().front();
        const QString file = withKnownEnding(chosen, dialog.defaultSuffix(), first, second);
        if (file == chosen || !QFileInfo::exists(file)) return file;
        dialog.selectFile(file); // once more: now it asks
    }
    return {};
}

QString askForReportFile(QWidget* parent, const QString& folder, const QString& name, const QString& title)
{
    return askForFile(parent, title.isEmpty() ? QObject::tr("Save Report") : title, folder, name, {QObject::tr("PDF"), "pdf"},
                      {QObject::tr("Web page"), "html"});
}

} // namespace hygroloom

#include "report_file.moc"
