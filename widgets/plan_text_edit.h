// The text of a plan: line numbers, colors, what is wrong with it marked where it stands.
#pragma once

#include <set>
#include <string_view>

#include <QPlainTextEdit>

#include "core/posh/finding.h"
#include "widgets/models/plan_notes.h"

namespace usar::widgets {

/// For reading; see PlanCodeEdit for writing. An error is underlined with a wave and has a cross beside its line, a
/// warning a dotted line and a triangle, a note a circle; tooltips say them. Lines of what runs are tinted and have a
/// bar. F8 and Shift+F8 go over all of these. GUI thread.
class PlanTextEdit : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit PlanTextEdit(QWidget* parent = nullptr);

    /// The findings and notes are those of this text.
    void setPlanText(std::string_view text, const posh::Findings& findings, std::vector<PlanNote> notes = {});
    const posh::Findings& findings() const { return findings_; }
    /// Of the text as it is now.
    void setFindings(const posh::Findings& findings, std::vector<PlanNote> notes = {});
    const std::vector<PlanNote>& notes() const { return notes_; }
    /// Counted from 1.
    void setRunningLines(const std::set<int>& lines);
    /// Brings it into view and marks it; no signal. Line 0 marks nothing.
    void showPlace(const posh::Spot& spot);
    void nextFinding(bool backward = false);
    /// The finding at the cursor's line, errors first; nullptr for none.
    const posh::Finding* findingAtCursor() const;
    /// The note at the cursor's line; nullptr for none.
    const PlanNote* noteAtCursor() const;
    QString toolTipAt(int line) const;
    int gutterWidth() const;
    void paintGutter(QPaintEvent* event);

signals:
    /// By the person; line and column count from 1, columns code points.
    void placeEntered(int line, int column);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

    /// Paints all marks anew.
    void mark();
    /// More marks, over those of findings.
    virtual void addMarks(QList<QTextEdit::ExtraSelection>&) const {}
    /// Selects the spot; what stands behind the end of the text is at its last line.
    QTextCursor cursorAt(const posh::Spot& spot) const;
    /// The cursor is moved by the program: no signal.
    bool& quiet() { return quiet_; }

private:
    void scrollToShown();
    void paintFindingMark(QPainter& painter, const QRectF& place, int line) const;

    posh::Findings findings_;
    std::vector<PlanNote> notes_;
    std::set<int> error_lines_;
    std::set<int> warning_lines_;
    std::set<int> note_lines_;
    std::set<int> running_lines_;
    posh::Spot shown_;
    QWidget* gutter_;
    bool quiet_ = false; ///< the cursor is moved by us
};

} // namespace usar::widgets
