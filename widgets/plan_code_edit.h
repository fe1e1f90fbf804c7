// The text of a plan for writing: completion with documentation, matching parentheses, indents, and edits made by
// others in the same history.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QAbstractItemDelegate>
#include <QCompleter>
#include <QToolButton>

#include "core/posh/token_splice.h"
#include "widgets/plan_text_edit.h"

class QStandardItemModel;

namespace usar::widgets {

/// A name that can be written: of a sense where senses are asked, else of an act or a form.
struct PlanWord {
    bool is_sense = false;
    QString name;
    QString help;
};

/// The document's own history is the only one and without limit; saving does not touch it. Ctrl+Space completes,
/// Alt+Return asks for mends, Ctrl+/ makes comments of lines. Tab leaves the editor, for people without a mouse; new
/// lines are indented by themselves. GUI thread.
class PlanCodeEdit : public PlanTextEdit {
    Q_OBJECT
public:
    explicit PlanCodeEdit(QWidget* parent = nullptr);

    /// UTF-8 with LF; the same as the reader's offsets count. Made anew only after a change.
    const std::string& planText() const;
    /// Another file: the history begins anew.
    void resetText(std::string_view text);
    /// One step in the history; nothing where the text is this already.
    void applyText(std::string_view wanted);
    void applyEdits(const std::vector<posh::Splice>& edits);

    void setWords(const std::vector<PlanWord>& words);
    /// In bytes.
    std::size_t cursorOffset() const;
    void setCursorOffset(std::size_t offset);
    /// A lamp beside the cursor's line: mends can be had for what is wrong there.
    void setLamp(bool on);

signals:
    /// After every change of the text, whoever made it.
    void textEdited();
    void mendsRequested();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void scrollContentsBy(int dx, int dy) override;
    void addMarks(QList<QTextEdit::ExtraSelection>& marks) const override;

private:
    void noticeChange();
    void complete(bool asked);
    void insertCompletion(const QString& word);
    QString wordBeforeCursor() const;
    bool asksSenses(std::size_t offset) const;
    void newLine();
    void toggleComment();
    void matchParentheses();
    void placeLamp();
    int positionOf(std::size_t offset) const;

    QCompleter* completer_;
    QAbstractItemDelegate* help_beside_;
    QStandardItemModel* senses_;
    QStandardItemModel* acts_;
    QToolButton* lamp_;
    mutable std::string text_;
    mutable int text_revision_ = -1;
    int seen_revision_ = 0;
    std::vector<int> matched_;   ///< positions of parentheses that belong together
    std::vector<int> unmatched_; ///< of one that has no other
};

} // namespace usar::widgets
