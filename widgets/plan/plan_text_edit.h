// Read-only view of the text of a plan: line numbers, colors, and marks for what is wrong with it.
#pragma once

#include <map>
#include <set>
#include <string_view>

#include <QPlainTextEdit>

#include "core/posh/model/finding.h"
#include "widgets/models/plan/plan_places.h"

namespace usar::widgets {

/// See PlanCodeEdit for editing. An error has a wavy underline and a cross beside its line, a warning a dotted
/// underline and a triangle, a note a circle; tooltips say what they mean. Lines that are running are tinted and have a
/// bar. F8 and Shift+F8 step through findings and notes. GUI thread.
class PlanTextEdit : public QPlainTextEdit {
    Q_OBJECT
public:
    explicit PlanTextEdit(QWidget* parent = nullptr);

    /// Replaces the text; findings and notes refer to this text.
    void setPlanText(std::string_view text, const posh::Findings& findings, std::vector<PlanNote> notes = {});
    const posh::Findings& findings() const { return findings_; }
    /// Sets the findings and notes of the current text.
    void setFindings(const posh::Findings& findings, std::vector<PlanNote> notes = {});
    const std::vector<PlanNote>& notes() const { return notes_; }
    /// Tints these lines, counted from 1.
    void setRunningLines(const std::set<int>& lines);
    /// Scrolls to a spot and marks it, without a signal. Line 0 removes the mark.
    void showPlace(const posh::Spot& spot);
    /// Moves the cursor to the next or previous finding or note; wraps around.
    void nextFinding(bool backward = false);
    /// The finding in the cursor's line, errors first; nullptr if there is none.
    const posh::Finding* findingAtCursor() const;
    /// The finding or note in the cursor's line in words; else how many errors and warnings there are, or nothing if
    /// there are none.
    QString wordsAtCursor() const;
    /// The findings and notes of a line, counted from 1; empty if there are none.
    QString toolTipAt(int line) const;
    /// Width of the strip with line numbers, in pixels.
    int gutterWidth() const;
    void paintGutter(QPaintEvent* event);

signals:
    /// The user moved the cursor; line and column count from 1, columns in code points.
    void placeEntered(int line, int column);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

    /// Sets all marks again.
    void mark();
    /// Adds marks of a subclass, painted over those of findings.
    virtual void addMarks(QList<QTextEdit::ExtraSelection>&) const {}
    /// Selects the spot; a spot after the end of the text is mapped to the last line.
    QTextCursor cursorAt(const posh::Spot& spot) const;

private:
    enum class Kind { Note, Warning, Error };
    /// A note or a finding, as it is shown.
    struct Remark {
        Kind kind;
        posh::Spot at;
        QString words;
    };
    void scrollToShown();
    void paintRemarkMark(QPainter& painter, const QRectF& place, Kind kind) const;

    posh::Findings findings_;
    std::vector<PlanNote> notes_;
    std::vector<Remark> remarks_;      ///< notes, then findings, which are marked over them
    std::map<int, Kind> remark_lines_; ///< the worst remark of each line that has any
    std::set<int> running_lines_;
    posh::Spot shown_; ///< the spot set by showPlace
    QWidget* gutter_;
    bool quiet_ = false; ///< the program moves the cursor, so placeEntered is not emitted
};

} // namespace usar::widgets
