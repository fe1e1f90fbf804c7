// Members of the plan editor: its widgets, and the state of the plan that is edited.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <QAction>
#include <QBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QSplitter>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>

#include "core/agent/posh/posh_primitive.h"
#include "core/posh/edit/plan_difference.h"
#include "core/posh/edit/quick_fixes.h"
#include "core/posh/language/plan_reader.h"
#include "widgets/plan/plan_canvas.h"
#include "widgets/plan/plan_code_edit.h"
#include "widgets/plan/plan_file.h"
#include "widgets/plan/plan_palette.h"

namespace usar::widgets {

/// Base of the editor, separate so that the editor's header shows what it does. The widgets are its children. GUI
/// thread.
struct PlanEditorParts {
    PlanFile file_;
    std::map<QString, QAction*> actions_;
    QMenu* new_menu_ = nullptr;
    QMenu* export_menu_ = nullptr;
    QMenu* compare_menu_ = nullptr;
    QMenu* part_menu_ = nullptr;

    QBoxLayout* head_ = nullptr;
    QLabel* title_ = nullptr;
    QToolButton* palette_shown_ = nullptr;
    QToolButton* text_shown_ = nullptr;
    QToolButton* drawing_shown_ = nullptr;
    QToolButton* lists_shown_ = nullptr;
    QPushButton* apply_ = nullptr;
    QSplitter* body_ = nullptr;
    QSplitter* column_ = nullptr;
    PlanPalette* palette_ = nullptr;
    PlanCodeEdit* text_ = nullptr;
    PlanCanvas* canvas_ = nullptr;
    QLabel* finding_ = nullptr;
    QToolButton* mend_ = nullptr;
    QLabel* stale_ = nullptr;
    QFrame* offer_ = nullptr;
    QLabel* offer_words_ = nullptr;
    QToolButton* offer_accept_ = nullptr;
    std::function<void()> offer_run_;
    QTabWidget* lists_ = nullptr;
    QListWidget* finding_list_ = nullptr;
    QListWidget* difference_list_ = nullptr;
    QListWidget* usage_list_ = nullptr;
    QLabel* state_ = nullptr;

    std::vector<agent::PrimitiveDescription> primitives_;
    posh::Vocabulary vocabulary_;
    QString running_name_;
    std::string running_text_;
    bool applicable_ = false;
    QString why_not_applicable_;

    posh::Findings findings_;
    posh::Plan checked_plan_; ///< result of reading the current text
    /// False after an edit, until the text is checked again.
    bool is_checked_ = false;
    /// Plan and text that the drawing shows.
    posh::Plan drawn_plan_;
    std::string drawn_text_;
    /// Edits of the drawn plan; nullopt while it cannot be edited.
    std::optional<PlanGestures> gestures_;
    std::optional<posh::PlanPart> swap_first_; ///< first part to swap; valid while the text is swap_text_
    std::string swap_text_;
    QTimer check_timer_;
    QTimer draw_timer_;
    QTimer lamp_timer_;
    /// The text is changing the drawing, or the drawing the text; keeps each from following itself.
    bool from_text_ = false;
    bool from_drawing_ = false;
    int narrow_ = -1; ///< 1: narrow layout, 0: wide; -1: not arranged yet
};

} // namespace usar::widgets
