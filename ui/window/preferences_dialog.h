// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The preferences, on pages that a list at the left chooses. What is chosen acts at once, but for what says otherwise.
#pragma once

#include "ui/basics/preferences.h"

#include <QDialog>

#include <functional>

class QComboBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QStackedWidget;
class QVBoxLayout;

namespace hygroloom {

class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    explicit PreferencesDialog(QWidget* parent = nullptr);

    void showPage(int page);
    /// Of all pages.
    void restoreDefaults();

private:
    QFormLayout* addPage(const QString& title, const QString& sentence = {});
    QComboBox* addChoice(QFormLayout& form, const QString& label, int Preferences::*value, const QStringList& names);
    void addNumber(QFormLayout& form, const QString& label, int Preferences::*value, int least, int most, const QString& unit,
                   const QString& of_zero, const QString& tip);
    void addTick(QFormLayout& form, const QString& label, int Preferences::*value);
    static QLabel* addNote(QFormLayout& form, const QString& sentence);
    void addUnits();
    void addLanguage();
    void addLook();
    void addMouse();
    void addAutosave();
    void addRuns();
    void addDevices();
    void listDevices(QFormLayout& form);
    void clearCache();
    void refresh();

    QListWidget* names_;
    QStackedWidget* pages_;
    QComboBox* language_ = nullptr;
    QComboBox* look_ = nullptr;
    QLabel* cache_ = nullptr;
    QFormLayout* devices_ = nullptr; ///< filled when it is first seen: asking GPUs takes time
    bool listed_ = false;
    std::vector<std::function<void()>> refreshers_;
};

} // namespace hygroloom
