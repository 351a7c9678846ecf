// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/weave/order_editor.h"

#include "ui/basics/appearance.h"
#include "ui/basics/ask.h"
#include "ui/basics/core_words.h"
#include "ui/basics/design_undo.h"
#include "ui/weave/cloth_picture.h"
#include "ui/weave/weave_edits.h"

#include <QAction>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>

#include <utility>

namespace hygroloom {

namespace {

/// The warp's colour, and the weft's where it differs.
QIcon swatch(const QColor& first, const QColor& second, const QPalette& palette)
{
    QPixmap pixmap(32, 32);
    pixmap.fill(first);
    QPainter painter(&pixmap);
    painter.fillRect(16, 0, 16, 32, second);
    painter.setPen(QPen(palette.color(QPalette::Mid), 2));
    painter.drawRect(1, 1, 30, 30);
    return pixmap;
}

QString described(const Yarn& yarn) { return yarn.material.empty() ? QString() : coreWord(yarn.material.front().name); }

} // namespace

/// One period of an order as text. What cannot be read stays, underlined, with the sentence that says why.
class OrderEdit : public QLineEdit {
public:
    explicit OrderEdit(const QString& name) : mark_(addAction(severityIcon(Severity::error), QLineEdit::TrailingPosition))
    {
        new DesignUndo(this);
        setAccessibleName(name);
        setPlaceholderText(OrderEditor::tr("all A"));
        setComplaint({});
        connect(mark_, &QAction::triggered, this, &OrderEdit::showTip);
        connect(this, &QLineEdit::textEdited, this, [this] { setComplaint({}); });
    }

    /// Takes a wrong text's place only when the order has changed.
    void showOrder(const QString& order)
    {
        if (order != order_ || complaint_.isEmpty()) {
            order_ = order;
            setComplaint({});
            if (text() != order) { setText(order); }
        }
    }

    void setComplaint(const QString& sentence)
    {
        complaint_ = sentence;
        mark_->setVisible(!sentence.isEmpty());
        const QString help =
            OrderEditor::tr("One repeat of the stripes, such as 12A 4B. A is the fabric's own yarn. Leave empty for no stripes.");
        setToolTip((sentence.isEmpty() ? QString() : "<p>" + sentence.toHtmlEscaped() + "</p>") + "<p>" + help + "</p>");
        setAccessibleDescription(sentence.isEmpty() ? help : sentence);
        update();
    }

    void showTip() { QToolTip::showText(mapToGlobal(QPoint(0, height())), toolTip(), this); }

protected:
    void keyPressEvent(QKeyEvent* event) override
    {
        if (event->key() == Qt::Key_Escape && text() != order_) {
            setComplaint({});
            setText(order_);
            return;
        }
        QLineEdit::keyPressEvent(event);
    }

    void paintEvent(QPaintEvent* event) override
    {
        QLineEdit::paintEvent(event);
        if (!complaint_.isEmpty()) {
            QPainter(this).fillRect(QRect(2, height() - 3, width() - 4, 2), severityColor(Severity::error, palette()));
        }
    }

private:
    QAction* mark_;
    QString order_; ///< of the design
    QString complaint_;
};

OrderEditor::OrderEditor(Document& document, QWidget* parent) : QWidget(parent), document_(document), list_(new QListWidget)
{
    list_->setAccessibleName(tr("Yarns of the fabric"));
    list_->setToolTip(
        "<p>" + tr("Select a yarn, then drag over the bars along the draft. Double-click it to edit its fibre, count and twist.") + "</p>");
    list_->setFrameShape(QFrame::NoFrame);
    list_->setIconSize({16, 16});
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    const auto add = [&](const char* icon, const QString& name, void (OrderEditor::*work)()) {
        auto* button = new QToolButton;
        button->setIcon(themedIcon(icon));
        button->setAutoRaise(true);
        button->setAccessibleName(name);
        button->setToolTip(name);
        connect(button, &QToolButton::clicked, this, work);
        buttons->addWidget(button);
        return button;
    };
    add("add", tr("Add a yarn like the warp"), &OrderEditor::addYarn);
    remove_ = add("remove", tr("Remove the selected yarn"), &OrderEditor::removeYarn);
    add("palette", tr("Colour of the selected yarn…"), &OrderEditor::pickColor);
    buttons->addStretch();
    auto* fields = new QFormLayout;
    fields->setContentsMargins(0, 0, 0, 0);
    fields->setSpacing(4);
    for (int system = 0; system < 2; ++system) {
        auto* edit = orders_[system] = new OrderEdit(system == 0 ? tr("Order of the ends") : tr("Order of the picks"));
        fields->addRow(system == 0 ? tr("Ends") : tr("Picks"), edit);
        connect(edit, &QLineEdit::editingFinished, this, [this, system] { setOrder(system == 0, orders_[system]->text()); });
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(list_, 1);
    layout->addLayout(buttons);
    layout->addLayout(fields);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) { remove_->setEnabled(row > 0); });
    connect(list_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) { Q_EMIT yarnActivated(list_->row(item)); });
    connect(&document_, &Document::designChanged, this, &OrderEditor::refresh);
    refresh();
}

int OrderEditor::chosenYarn() const { return std::max(0, list_->currentRow()); }

void OrderEditor::chooseYarn(int yarn) { list_->setCurrentRow(yarn); }

void OrderEditor::showOrder(bool warp) { orders_[warp ? 0 : 1]->setFocus(); }

void OrderEditor::refresh()
{
    const Fabric* fabric = document_.fabric();
    setEnabled(fabric != nullptr);
    const int chosen = list_->currentRow();
    const QSignalBlocker quiet(list_);
    list_->clear();
    if (!fabric) { return; }
    list_->addItem(
        new QListWidgetItem(swatch(yarnColor(fabric->warp, true), yarnColor(fabric->weft, false), palette()), tr("A  warp | weft")));
    for (std::size_t i = 0; i < fabric->extra_yarns.size(); ++i) {
        const Yarn& yarn = fabric->extra_yarns[i];
        list_->addItem(new QListWidgetItem(swatch(yarnColor(yarn, true), yarnColor(yarn, true), palette()),
                                           yarnLetter(static_cast<int>(i) + 1) + "  " + described(yarn)));
    }
    list_->setCurrentRow(std::clamp(chosen, 0, list_->count() - 1));
    remove_->setEnabled(list_->currentRow() > 0);
    const bool another = std::exchange(fabric_, document_.fabricIndex()) != document_.fabricIndex();
    for (int system = 0; system < 2; ++system) {
        if (another) {
            orders_[system]->setComplaint({}); // what was typed was for the other one
        }
        orders_[system]->showOrder(orderText(system == 0 ? fabric->warp_order : fabric->weft_order));
    }
}

void OrderEditor::edit(const QString& undo, const std::string& field, const std::function<void(Fabric&)>& change)
{
    if (document_.fabric()) {
        const auto index = static_cast<std::size_t>(document_.fabricIndex());
        document_.edit(undo, field, [&](Design& design) { change(design.fabrics[index]); });
    }
}

void OrderEditor::paintThread(Fabric& fabric, bool warp, int thread, int period) const
{
    std::vector<int> yarns = threadYarns(fabric, warp, period);
    int& one = yarns[static_cast<std::size_t>(wrapped(thread, period))];
    if (one != chosenYarn()) {
        one = chosenYarn();
        setThreadYarns(fabric, warp, yarns);
    }
}

void OrderEditor::addYarn()
{
    if (!document_.fabric() || document_.fabric()->extra_yarns.size() >= most_extra_yarns) { return; }
    constexpr Color inks[] = {{31, 78, 121}, {163, 45, 45}, {58, 110, 66}, {196, 141, 40}, {92, 66, 120}, {52, 52, 56}};
    document_.endStroke();
    edit(tr("add yarn"), {}, [&](Fabric& fabric) {
        Yarn yarn = fabric.warp;
        yarn.color = inks[fabric.extra_yarns.size() % std::size(inks)];
        fabric.extra_yarns.push_back(yarn);
    });
    list_->setCurrentRow(list_->count() - 1);
}

void OrderEditor::removeYarn()
{
    const int gone = chosenYarn();
    if (gone == 0) { return; }
    edit(tr("remove yarn"), {}, [gone](Fabric& fabric) {
        fabric.extra_yarns.erase(fabric.extra_yarns.begin() + gone - 1);
        for (std::vector<YarnRun>* order : {&fabric.warp_order, &fabric.weft_order}) {
            for (YarnRun& run : *order) { run.yarn = run.yarn == gone ? 0 : run.yarn > gone ? run.yarn - 1 : run.yarn; }
        }
        for (const bool warp : {true, false}) { setThreadYarns(fabric, warp, threadYarns(fabric, warp, orderPeriod(fabric, warp))); }
    });
}

void OrderEditor::setColor(const QColor& color)
{
    const int yarn = chosenYarn();
    edit(tr("yarn colour"), {}, [&](Fabric& fabric) {
        const Color made{static_cast<std::uint8_t>(color.red()), static_cast<std::uint8_t>(color.green()),
                         static_cast<std::uint8_t>(color.blue())};
        if (yarn > 0) {
            fabric.extra_yarns[static_cast<std::size_t>(yarn - 1)].color = made;
        } else {
            fabric.warp.color = fabric.weft.color = made;
        }
    });
}

void OrderEditor::pickColor()
{
    if (const Fabric* fabric = document_.fabric()) {
        if (const auto color = askColor(this, tr("Yarn Colour"), yarnColor(yarn_in(*fabric, true, chosenYarn()), true))) {
            setColor(*color);
        }
    }
}

void OrderEditor::setOrder(bool warp, const QString& text)
{
    const Fabric* fabric = document_.fabric();
    OrderEdit* field = orders_[warp ? 0 : 1];
    if (!fabric || text == orderText(warp ? fabric->warp_order : fabric->weft_order)) { return; }
    QString why;
    const auto order = orderFromText(text, static_cast<int>(fabric->extra_yarns.size()) + 1, &why);
    field->setComplaint(order ? QString() : why);
    if (!order) {
        field->showTip();
        return;
    }
    document_.endStroke();
    edit(warp ? tr("order of the ends") : tr("order of the picks"), {}, [&](Fabric& f) { (warp ? f.warp_order : f.weft_order) = *order; });
}

} // namespace hygroloom
