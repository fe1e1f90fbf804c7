// The text of a plan that is edited, above a line about the finding at the cursor and the fixes for it.
#pragma once

#include <vector>

#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "core/posh/edit/quick_fixes.h"
#include "widgets/plan/editor/plan_code_edit.h"

namespace usar::widgets {

/// Does not look for fixes itself: signals request them, and setters take them. GUI thread.
class PlanTextPane : public QWidget {
    Q_OBJECT
public:
    explicit PlanTextPane(QWidget* parent = nullptr);

    PlanCodeEdit& edit() { return *edit_; }
    /// Shows the finding in the cursor's line, or the number of findings if that line has none. `fits_robot`: the plan
    /// was checked against a robot. The lamp is off until setFixable turns it on.
    void showFinding(bool fits_robot);
    /// Lights the lamp and shows the button for fixes, or hides both.
    void setFixable(bool fixable);
    /// Opens a menu of fixes at the cursor; it must not be empty.
    void showFixes(const std::vector<posh::QuickFix>& fixes);

signals:
    /// The cursor has stayed for a moment: setFixable is wanted.
    void pausedAtFinding();
    /// The user wants to choose a fix.
    void fixesRequested();
    /// The user chose a fix, which has changed the text.
    void fixed();

private:
    PlanCodeEdit* edit_;
    QLabel* finding_;
    QToolButton* fix_;
    QTimer lamp_timer_;
};

} // namespace usar::widgets
