// Editor for the text of a plan: completion with documentation, matching parentheses, indentation; edits made by the
// program are part of the same undo history.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QAbstractItemDelegate>
#include <QCompleter>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "core/posh/edit/quick_fixes.h"
#include "core/posh/language/token_splice.h"
#include "widgets/plan/plan_text_edit.h"

class QStandardItemModel;

namespace usar::widgets {

/// A name that completion offers: of a sense where senses are expected, else of an act or a form.
struct PlanWord {
    bool is_sense = false;
    QString name;
    QString help;
};

/// The document's own undo history is the only one, is unlimited, and is not affected by saving. Ctrl+Space completes,
/// Alt+Return asks for fixes, Ctrl+/ comments lines out or in. Tab leaves the editor, for users without a mouse; new
/// lines are indented automatically. GUI thread.
class PlanCodeEdit : public PlanTextEdit {
    Q_OBJECT
public:
    explicit PlanCodeEdit(QWidget* parent = nullptr);

    /// The text as UTF-8 with LF, which is what the reader's offsets refer to. Computed again only after a change.
    const std::string& planText() const;
    /// Replaces the text and clears the undo history, for another file.
    void resetText(std::string_view text);
    /// Changes the text to `wanted` as one undo step with minimal edits; does nothing if it is the same already.
    void applyText(std::string_view wanted);
    /// Applies these edits as one undo step; offsets are bytes of planText() before all of them.
    void applyEdits(const std::vector<posh::Splice>& edits);

    /// Sets the names that completion offers.
    void setWords(const std::vector<PlanWord>& words);
    /// Position of the cursor in bytes of planText().
    std::size_t cursorOffset() const;
    /// Shows or hides a lamp beside the cursor's line, which says that fixes are available there.
    void setLamp(bool on);

signals:
    /// Emitted after every change of the text, whoever made it.
    void textEdited();
    /// The user asked for fixes at the cursor, by Alt+Return or the lamp.
    void fixesRequested();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void addMarks(QList<QTextEdit::ExtraSelection>& marks) const override;

private:
    /// Emits textEdited if the text changed; coloring changes only formats.
    void noticeChange();
    /// Opens the completion list; `asked`: by the user's request, else while typing.
    void complete(bool asked);
    void insertCompletion(const QString& word);
    QString wordBeforeCursor() const;
    /// True if senses are expected at this offset, that is in a trigger or goal.
    bool asksSenses(std::size_t offset) const;
    void newLine();
    void toggleComment();
    void matchParentheses();
    void placeLamp();
    /// Converts bytes of planText() to a position in the document.
    int positionOf(std::size_t offset) const;

    QCompleter* completer_;
    QAbstractItemDelegate* help_beside_;
    QStandardItemModel* senses_;
    QStandardItemModel* acts_;
    QToolButton* lamp_;
    mutable std::string text_;
    /// Revision of the document that text_ belongs to.
    mutable int text_revision_ = -1;
    int seen_revision_ = 0;
    std::vector<int> matched_;   ///< positions of the parentheses that match at the cursor
    std::vector<int> unmatched_; ///< positions of parentheses without a match
};

/// The text above a line about the finding at the cursor and the fixes for it. Does not look for fixes itself: signals
/// request them, and setters take them. GUI thread.
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
