// Sections with titles, one above the other where there is room for all of them, else one at a time with tabs.
#pragma once

#include <vector>

#include <QLabel>
#include <QTabBar>
#include <QVBoxLayout>
#include <QWidget>

namespace usar::widgets {

/// A section of which half a row would be seen says nothing: each gets `least_px` or stands behind a tab. A hidden
/// section has neither room nor tab. GUI thread.
class SectionStack : public QWidget {
    Q_OBJECT
public:
    static constexpr int least_px = 88; ///< title and three rows

    /// `name` is that of the tabs together, for those who hear it.
    explicit SectionStack(const QString& name, QWidget* parent = nullptr);

    /// Takes both. Among stacked sections the room is shared out by `stretch`.
    void add(QLabel* title, QWidget* body, const QString& tab, int stretch);
    void setSectionShown(const QWidget* body, bool shown);
    /// Behind tabs, too, the title is seen: it says more than the tab does.
    void setTitleKept(const QWidget* body, bool kept);
    /// That one is seen, where only one is.
    void show(const QWidget* body);
    using QWidget::show;
    bool tabbed() const { return tabbed_; }

    QSize minimumSizeHint() const override { return {120, least_px + 24}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Section {
        QLabel* title = nullptr;
        QWidget* body = nullptr;
        QString tab;
        bool shown = true;
        bool keeps_title = false;
    };
    Section* sectionOf(const QWidget* body);
    void arrange();
    void showTabs();

    std::vector<Section> sections_;
    QVBoxLayout* column_;
    QTabBar* tabs_; ///< of the shown sections, by their numbers as data
    bool tabbed_ = false;
};

} // namespace usar::widgets
