// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// German beside English: every text has its translation, and the window shows it. Needs a display: xvfb-run.
#include "core/analysis/outcomes.h"
#include "core/design/garment.h"
#include "core/design/liquid.h"
#include "core/design/material.h"
#include "core/design/validate.h"
#include "core/design/weave.h"
#include "core/plan/fidelity.h"
#include "core/project/library.h"
#include "core/wear/wear_outcomes.h"
#include "ui/basics/core_words.h"
#include "ui/basics/elided_combo.h"
#include "ui/basics/issue_text.h"
#include "ui/basics/language.h"
#include "ui/basics/quantity_edit.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/garment_panel.h"
#include "ui/garment/panel_table.h"
#include "window_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QGroupBox>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QProcess>
#include <QRegularExpression>
#include <QTabBar>
#include <QXmlStreamReader>

#include <algorithm>
#include <set>

using namespace hygroloom;

namespace {

const QString file = QString(HYGROLOOM_SOURCE_DIR) + "/resources/translations/hygroloom_de.ts";

struct Entry {
    QString context, source;
    QStringList translations; ///< one, or the plural's two
    bool plural = false, unfinished = false;
};

QStringList formsOf(QXmlStreamReader& xml)
{
    QStringList forms;
    QString text;
    while (!xml.atEnd() && !(xml.readNext() == QXmlStreamReader::EndElement && xml.name() == u"translation")) {
        if (xml.isStartElement()) { forms << xml.readElementText(); }
        if (xml.isCharacters()) { text += xml.text(); }
    }
    return forms.isEmpty() ? QStringList{text} : forms;
}

std::vector<Entry> messagesOf(const QString& path)
{
    std::vector<Entry> messages;
    QFile ts(path);
    if (!ts.open(QIODevice::ReadOnly)) { return messages; }
    QXmlStreamReader xml(&ts);
    QString context;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) { continue; }
        if (xml.name() == u"name") { context = xml.readElementText(); }
        if (xml.name() == u"message") { messages.push_back({context, {}, {}, xml.attributes().value("numerus") == u"yes", false}); }
        if (xml.name() == u"source") { messages.back().source = xml.readElementText(); }
        if (xml.name() == u"translation") {
            messages.back().unfinished = xml.attributes().value("type") == u"unfinished";
            messages.back().translations = formsOf(xml);
        }
    }
    return messages;
}

/// What a translation must keep: places of arguments, tags, spaces at the ends.
QStringList keptOf(const QString& text)
{
    static const QRegularExpression form("%(?:[1-9]|n)|<[^>]*>");
    QStringList kept;
    for (auto each = form.globalMatch(text); each.hasNext();) { kept << each.next().captured(); }
    kept.sort();
    kept.removeDuplicates(); // the order of words, and how often an argument is named, are the language's
    return kept << (text.startsWith(' ') ? "space before" : "") << (text.endsWith(' ') ? "space after" : "");
}

QString withoutKeys(const QString& text) { return QString(text).remove('&'); }

/// English texts that no translation leaves as they are.
std::set<QString> englishOnly()
{
    std::set<QString> english, same;
    for (const Entry& message : messagesOf(file)) {
        const QString source = withoutKeys(message.source);
        (withoutKeys(message.translations.value(0)) == source ? same : english).insert(source);
    }
    for (const QString& word : same) { english.erase(word); }
    return english;
}

} // namespace

class TestTranslation : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        useOwnSettings();
        QSettings().setValue("look/language", "de");
        install_language(*QCoreApplication::instance());
        openWindow(QSize(1280, 800));
        QVERIFY(window_->openFile(example("laboratory")));
    }

    void cleanupTestCase() { window_.reset(); }

    void everyTextHasATranslationThatKeepsItsPlacesAndTags()
    {
        const std::vector<Entry> messages = messagesOf(file);
        QVERIFY(messages.size() > 1500);
        for (const Entry& message : messages) {
            const QString name = message.context + ": " + message.source;
            QVERIFY2(!message.unfinished, qPrintable(name));
            QCOMPARE(message.translations.size(), message.plural ? 2 : 1);
            for (const QString& text : message.translations) {
                QVERIFY2(!text.isEmpty(), qPrintable(name));
                QVERIFY2(keptOf(text) == keptOf(message.source), qPrintable(name + " => " + text));
                const auto keyed = [](const QString& words) { return !QKeySequence::mnemonic(words).isEmpty(); };
                QVERIFY2(keyed(text) == keyed(message.source), qPrintable(name + " => " + text));
            }
        }
    }

    void theFileHasTheTextsOfTheSources()
    {
        QTemporaryDir copy;
        QProcess script;
        script.start(QString(HYGROLOOM_SOURCE_DIR) + "/packaging/translations.sh", {copy.path()});
        QVERIFY(script.waitForFinished(120000));
        const QString said = script.readAllStandardError();
        if (said.contains("There is no lupdate")) { QSKIP("lupdate of Qt 6 is not installed."); }
        QVERIFY2(script.exitStatus() == QProcess::NormalExit && script.exitCode() == 0, qPrintable(said));
        const auto named = [](const QString& path) {
            std::set<QString> all;
            for (const Entry& message : messagesOf(path)) { all.insert(message.context + ": " + message.source); }
            return all;
        };
        const std::set<QString> found = named(copy.filePath("hygroloom_de.ts")), own = named(file);
        for (const QString& text : found) {
            QVERIFY2(own.count(text), qPrintable("Run packaging/translations.sh; not in the file: " + text));
        }
        for (const QString& text : own) { QVERIFY2(found.count(text), qPrintable("Run packaging/translations.sh; gone: " + text)); }
    }

    void theTableHasCoresNames()
    {
        std::set<std::string> named;
        for (int type = 0; type < experiment_types; ++type) {
            const auto of = static_cast<ExperimentType>(type);
            for (const OutcomeInfo& info : reported_by(of)) { named.insert({info.title, info.part}); }
            named.insert(info_of(of).title);
            if (of != ExperimentType::droplet) { named.insert(QString(info_of(of).title).toLower().toStdString()); }
        }
        for (const Plot& plot : all_plots()) {
            named.insert(plot.title);
            for (const Curve& curve : plot.curves) { named.insert(curve.name); }
        }
        for (const WearNumber& number : wear_numbers()) {
            if (number.decimals) { named.insert(number.info.title); } // in the window's table
        }
        for (const auto& rows : {water_balance({}), balance_check({})}) {
            for (const BalanceRow& row : rows) { named.insert(row.title); }
        }
        for (const WeaveGroup& group : weave_catalogue()) { named.insert(group.name); }
        for (const Preset& preset : shipped_presets()) { named.insert(preset.group); }
        for (const Finish& finish : finishes()) { named.insert(finish.name); }
        for (const Material& material : material_library()) { named.insert(material.name); }
        for (const Liquid& liquid : library_liquids()) { named.insert(liquid.name); }
        for (const auto& names : {gap_zones(), built_in_garments(), sweat_tables()}) { named.insert(names.begin(), names.end()); }
        for (const KnobInfo& knob : knob_table()) { named.insert(QString(knob.name).replace('_', ' ').toStdString()); }
        for (const Fidelity fidelity : all_fidelities) { named.insert(name_of(fidelity)); }
        named.erase("");
        std::set<std::string> table;
        for (const Entry& entry : messagesOf(file)) {
            if (entry.context == "core") { table.insert(entry.source.toStdString()); }
        }
        for (const std::string& name : named) { QVERIFY2(table.count(name), name.c_str()); }
        QCOMPARE(coreTitle("wetted radius", "top"), QString("Benetzungsradius, oben"));
        QCOMPARE(coreWord("a name that somebody gave"), QString("a name that somebody gave"));
    }

    void issuesAreInTheLanguageOfTheWindow()
    {
        Design design = *window_->document().design();
        design.fabrics[0].warp.twist_per_m = 6000;
        QCOMPARE(issueText(validate(design).front()), QString("Drehung: Erlaubt ist 0 bis 5000 /m; gegeben ist 6000."));
        design.fabrics[0].warp.material = {{"coton", 1}};
        const std::vector<Issue> issues = validate(design);
        QVERIFY(std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
            return issueText(issue).startsWith(QString::fromUtf8("Es gibt kein Material „coton“; meinten Sie „cotton“? Bekannt sind: "));
        }));
        QCOMPARE(messageText(say("In no table: {}", "a name")), QString("In no table: a name"));
    }

    void noTextOfTheWindowIsEnglish()
    {
        std::set<QString> english = englishOnly();
        for (const Experiment& experiment : window_->document().design()->experiments) { // whose names are the project's
            english.erase(QString::fromStdString(experiment.name));
        }
        QVERIFY(english.size() > 1000);
        QStringList left;
        const auto look = [&](const QObject& where, const QString& text) {
            const QString words = withoutKeys(text.section('\t', 0, 0)).remove("<p>").remove("</p>");
            if (english.count(words)) { left << QString("%1: %2").arg(where.metaObject()->className(), words); }
        };
        for (const Workspace each : {Workspace::design, Workspace::simulate, Workspace::compare, Workspace::garment, Workspace::study}) {
            window_->setWorkspace(each);
            QCoreApplication::processEvents();
            for (const QAction* action : window_->findChildren<QAction*>()) {
                look(*action, action->text());
                look(*action, action->toolTip());
                look(*action, action->statusTip());
            }
            for (const QWidget* widget : window_->findChildren<QWidget*>()) {
                look(*widget, widget->toolTip());
                look(*widget, widget->accessibleName());
                look(*widget, widget->windowTitle());
                if (const auto* label = qobject_cast<const QLabel*>(widget)) { look(*label, label->text()); }
                if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) { look(*button, button->text()); }
                if (const auto* box = qobject_cast<const QGroupBox*>(widget)) { look(*box, box->title()); }
                if (const auto* bar = qobject_cast<const QTabBar*>(widget)) {
                    for (int i = 0; i < bar->count(); ++i) { look(*bar, bar->tabText(i)); }
                }
                if (const auto* head = qobject_cast<const QHeaderView*>(widget); head && head->model()) {
                    for (int i = 0; i < head->count(); ++i) { look(*head, head->model()->headerData(i, head->orientation()).toString()); }
                }
                if (const auto* choice = qobject_cast<const QComboBox*>(widget)) {
                    for (int i = 0; i < choice->count(); ++i) { look(*choice, choice->itemText(i)); }
                }
            }
        }
        left.removeDuplicates();
        QVERIFY2(left.isEmpty(), qPrintable(left.join("\n")));
    }

    void namesOfFabricsAreWholeInAGarment()
    {
        QVERIFY(window_->openFile(example("three-candidates")));
        window_->setWorkspace(Workspace::garment);
        window_->run().garment().choice().setGarmentIndex(addBuiltInGarment(window_->document(), "tee"));
        QTRY_VERIFY(window_->run().garment().choice().drawing());
        QTest::qWait(200);
        const PanelTable& panels = window_->run().garment().panel().panels();
        QVERIFY(panels.rowCount() > 0);
        for (int row = 0; row < panels.rowCount(); ++row) {
            const auto* fabric = static_cast<ElidedCombo*>(panels.cellWidget(row, 1));
            QCOMPARE(fabric->shownText(), QString("Cotton plain"));
        }
        window_->document().history()->setClean();
        QVERIFY(window_->openFile(example("laboratory")));
    }

    void keysOfAMenuDiffer()
    {
        QStringList twice;
        for (const QMenu* menu : window_->findChildren<QMenu*>()) {
            std::map<QString, QString> keys;
            for (const QAction* action : menu->actions()) {
                const QString key = QKeySequence::mnemonic(action->text()).toString();
                if (key.isEmpty()) { continue; }
                if (keys.count(key)) { twice << menu->title() + ": " + keys[key] + ", " + action->text(); }
                keys[key] = action->text();
            }
        }
        twice.removeDuplicates();
        QVERIFY2(twice.isEmpty(), qPrintable(twice.join("\n")));
    }

    void numbersHavePointsAndCommasAreTaken()
    {
        QuantityEdit edit(Quantity::length(0, 10));
        QCOMPARE(Quantity::length(0, 10).parse("1,25 mm").value_or(0), 1.25);
        edit.setValue(1.25);
        QVERIFY2(edit.text().startsWith("1.25"), qPrintable(edit.text()));
        QCOMPARE(shortMoment(QDateTime(QDate(2024, 3, 9), QTime(14, 5))).left(8), QString("09.03.24"));
    }

    void anUnknownLanguageIsTheSystemsOrEnglish()
    {
        QSettings().setValue("look/language", "xx");
        const QString system = chosenLanguage();
        QVERIFY(system == "en" || system == "de");
        QSettings().setValue("look/language", "en");
        QCOMPARE(chosenLanguage(), QString("en"));
        QSettings().setValue("look/language", "de");
        QCOMPARE(chosenLanguage(), QString("de"));
        QCOMPARE(languages().front().name, QString("English"));
        QCOMPARE(inShownLanguage(":/lessons/fibre.json"), QString(":/lessons/de/fibre.json"));
        QCOMPARE(inShownLanguage(":/lessons/none.json"), QString(":/lessons/none.json"));
    }
};

QTEST_MAIN(TestTranslation)
#include "tst_translation.moc"
