// The row of buttons above a plan that is edited: file, history and comparison at the left; visibility of the panes and
// "Load into robot" at the right.
#pragma once

#include <functional>

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>

#include "widgets/plan/editor/plan_actions.h"

namespace usar::widgets {

/// The parts of the editor that its buttons show and hide.
struct PlanEditorPanes {
    QWidget* palette;
    QWidget* text;
    QWidget* drawing;
    QWidget* lists;
};
/// The menus that its buttons open.
struct PlanEditorMenus {
    QMenu* new_plan = nullptr;
    QMenu* save_as = nullptr;
    QMenu* compare = nullptr;
};

/// The editor owns panes and menus. GUI thread.
class PlanEditorHead : public QWidget {
    Q_OBJECT
public:
    PlanEditorHead(const PlanActions& actions, const PlanEditorPanes& panes, const PlanEditorMenus& menus,
                   QWidget* parent = nullptr);

    /// Returns false if the title is unchanged; then the tooltip stays unchanged, too.
    bool setTitle(const QString& title, const QString& help);
    /// Enables "Load into robot" if the plan is runnable, too. Else its tooltip says `why_not`; it is hidden if that
    /// is empty.
    void setApplicable(bool applicable, const QString& why_not);
    /// `runnable`: a robot could run the current text of the plan.
    void setRunnable(bool runnable);
    /// A narrow head has two rows.
    void setNarrow(bool narrow) { rows_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight); }

    void setPaletteShown(bool shown) { palette_shown_->setChecked(shown); }
    void showText() { text_shown_->setChecked(true); }
    void showDrawing() { drawing_shown_->setChecked(true); }
    void showLists() { lists_shown_->setChecked(true); }

private:
    void addButton(QBoxLayout* row, QAction* action);
    void addMenuButton(QBoxLayout* row, const QString& help, const QString& icon_name, QMenu* menu);
    QToolButton* addToggle(QBoxLayout* row, const QString& help, const char* icon_name, QWidget* what);

    void showApply();

    QBoxLayout* rows_;
    QLabel* title_;
    QToolButton* palette_shown_;
    QToolButton* text_shown_;
    QToolButton* drawing_shown_;
    QToolButton* lists_shown_;
    QPushButton* apply_;
    QAction* apply_action_;
    bool applicable_ = false;
    bool runnable_ = false;
    QString why_not_applicable_;
};

/// Bar for a question that needs no immediate answer. Stays visible until the question is answered; hidden at first.
/// GUI thread.
class PlanOfferBar : public QFrame {
    Q_OBJECT
public:
    explicit PlanOfferBar(QWidget* parent = nullptr);

    /// Asks a question in place of the last one; calls `run` if the user accepts.
    void offer(const QString& words, const QString& accept, std::function<void()> run);

private:
    QLabel* words_;
    QToolButton* accept_;
    std::function<void()> run_;
};

} // namespace usar::widgets
