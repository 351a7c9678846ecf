// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/results/report_file.h"

#include "core/project/atomic_file.h"
#include "ui/basics/quantity.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QFileDialog>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgRenderer>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>
#include <QTextObjectInterface>

#include <cmath>
#include <map>
#include <memory>

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

/// Maps that follow each other, two to a row.
QString twoInARow(const QString& html)
{
    static const QRegularExpression maps("(?:<figure><img alt.*?</figure>\\s*)+", QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression one("<figure>(<img alt.*?)</figure>", QRegularExpression::DotMatchesEverythingOption);
    QString done;
    qsizetype end = 0;
    for (const QRegularExpressionMatch& row : maps.globalMatch(html)) {
        done += html.mid(end, row.capturedStart() - end) + "<table>";
        int column = 0;
        for (const QRegularExpressionMatch& map : one.globalMatch(row.captured())) {
            if (column++ % 2 == 0) done += "<tr>";
            done += "<td>" + map.captured(1) + "</td>";
        }
        done += "</table>";
        end = row.capturedEnd();
    }
    return done + html.mid(end);
}

/// Rich text of Qt knows no SVG, no figures and no captions.
QString asRichText(QString html, Pictures& pictures, QTextDocument& document)
{
    static const QRegularExpression svg("<svg.*?</svg>", QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression png("src=\"data:image/png;base64,([^\"]*)\"");
    for (QRegularExpressionMatch found; (found = svg.match(html)).hasMatch();)
        html.replace(found.capturedStart(), found.capturedLength(),
                     QString("<img src=\"%1\">").arg(pictures.add(found.captured().toUtf8())));
    for (int number = 0;; ++number) {
        const QRegularExpressionMatch found = png.match(html);
        if (!found.hasMatch()) break;
        const QString name = QString("map:%1").arg(number);
        document.addResource(QTextDocument::ImageResource, QUrl(name),
                             QImage::fromData(QByteArray::fromBase64(found.captured(1).toLatin1())));
        html.replace(found.capturedStart(), found.capturedLength(), QString("src=\"%1\"").arg(name));
    }
    html = twoInARow(html);
    static const QRegularExpression style("<style>.*?</style>", QRegularExpression::DotMatchesEverythingOption);
    static const QRegularExpression details("</?details[^>]*>");
    html.remove(style).remove(details);
    for (const auto& [tag, instead] : {std::pair("<figure>", "<p>"),
                                       {"</figure>", "</p>"},
                                       {"<figcaption>", "<br>"},
                                       {"</figcaption>", ""},
                                       {"<summary>", "<h3>"},
                                       {"</summary>", "</h3>"},
                                       {"<table>", "<table cellspacing=\"0\" cellpadding=\"3\">"}})
        html.replace(tag, instead);
    return html;
}

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
void layOut(QTextDocument& document, QString html)
{
    static const QRegularExpression heading("<h[1-3][ >]");
    for (;;) {
        document.setHtml(html);
        document.setPageSize({text_width, text_height});
        int lonely = lonelyHeading(document);
        if (lonely < 0) return;
        qsizetype at = -1;
        for (const QRegularExpressionMatch& one : heading.globalMatch(html))
            if (lonely-- == 0) at = one.capturedStart();
        if (at < 0 || html.mid(at + 3).startsWith(" style")) return;
        html.insert(at + 3, " style=\"page-break-before: always\"");
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

std::string pdfOf(const QString& html)
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
    layOut(document, asRichText(html, *pictures, document));
    drawPages(document, writer);
    return bytes.toStdString();
}

void writeReport(const QString& html, const QString& file)
{
    const bool pdf = file.endsWith(".pdf", Qt::CaseInsensitive);
    write_file(file.toStdString(), pdf ? pdfOf(html) : html.toStdString());
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
    return dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty() ? dialog.selectedFiles().front() : QString();
}

QString askForReportFile(QWidget* parent, const QString& folder, const QString& name)
{
    return askForFile(parent, QObject::tr("Save Report"), folder, name, {QObject::tr("PDF"), "pdf"}, {QObject::tr("Web page"), "html"});
}

} // namespace hygroloom

#include "report_file.moc"
