// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/window/guide_search.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTextBlock>
#include <QTextDocument>

#include <algorithm>

namespace hygroloom {

namespace {

constexpr int before_hit = 40, context_length = 160; // letters

struct Page {
    QString name;
    QStringList paragraphs; ///< the first is its heading
};

/// As the window shows them, so that it finds what is found here. Read once.
const std::vector<Page>& pages()
{
    static const std::vector<Page> all = [] {
        std::vector<Page> read;
        for (const QFileInfo& info : QDir(":/help").entryInfoList({"*.md"}, QDir::Files, QDir::Name)) {
            QFile file(info.filePath());
            if (!file.open(QIODevice::ReadOnly)) { continue; }
            QTextDocument document;
            document.setMarkdown(QString::fromUtf8(file.readAll()));
            Page page{info.completeBaseName(), {}};
            for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) { page.paragraphs << block.text(); }
            read.push_back(page);
        }
        return read;
    }();
    return all;
}

/// From a word before the hit to a word after it.
QString contextOf(const QString& paragraph, qsizetype hit)
{
    const qsizetype space = hit <= before_hit ? -1 : paragraph.indexOf(' ', hit - before_hit);
    const qsizetype from = hit <= before_hit ? 0 : space < 0 || space >= hit ? hit : space + 1;
    return (from > 0 ? "… " : "") + paragraph.mid(from, context_length).simplified() +
           (from + context_length < paragraph.size() ? " …" : "");
}

} // namespace

std::vector<GuideHit> searchGuide(const QString& text)
{
    std::vector<GuideHit> found;
    const QString words = text.trimmed();
    if (words.isEmpty()) { return found; }
    for (const Page& page : pages()) {
        GuideHit hit{page.name, page.paragraphs.value(0), {}, 0};
        for (const QString& paragraph : page.paragraphs) {
            const auto here = static_cast<int>(paragraph.count(words, Qt::CaseInsensitive));
            if (here > 0 && hit.hits == 0) { hit.context = contextOf(paragraph, paragraph.indexOf(words, 0, Qt::CaseInsensitive)); }
            hit.hits += here;
        }
        if (hit.hits > 0) { found.push_back(hit); }
    }
    const auto in_title = [&](const GuideHit& hit) { return hit.title.contains(words, Qt::CaseInsensitive); };
    std::stable_sort(found.begin(), found.end(),
                     [&](const GuideHit& a, const GuideHit& b) { return in_title(a) != in_title(b) ? in_title(a) : a.hits > b.hits; });
    return found;
}

} // namespace hygroloom
