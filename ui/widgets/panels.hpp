#pragma once

// Panels: the fixed parts of the window round the viewport. Each draws itself into the rectangle it is given.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/document/group_tree.hpp"
#include "ui/base/marks.hpp"
#include "ui/base/samples.hpp"
#include "ui/base/theme.hpp"
#include "ui/editor/command_table.hpp"
#include "ui/editor/continuity_text.hpp"
#include "ui/editor/editor.hpp"
#include "ui/widgets/offers.hpp"
#include "ui/widgets/steady_rows.hpp"

namespace hariko {

/// The groups of a document as the list shows them, and what they were made from.
struct OutlinerTree {
  std::vector<std::shared_ptr<const Object>> objects;
  Shared<Groups> groups;
  std::shared_ptr<const GroupTree> tree;
  std::map<ObjectId, std::size_t> places;  ///< places of the objects in the document
};

/// State of the list of objects between frames.
struct OutlinerState {
  ObjectId renaming;        ///< object whose name is a field now
  std::string name;         ///< contents of that field
  bool focus_name = false;  ///< the field has just appeared
  ObjectId anchor;          ///< object at which a range chosen with Shift begins
  enum class Order { document, name, kind, newest };
  Order order = Order::document;
  std::string search;           ///< shows the objects whose names have it
  std::vector<ObjectId> shown;  ///< the rows, from above
  ObjectId shown_active;        ///< the active object that the list has scrolled to
  std::set<GroupId> folded;     ///< groups whose contents do not show
  std::uint64_t documents = 0;  ///< `Editor::documents` of the document that they are of
  GroupId renaming_group;       ///< group whose name is a field now
  std::optional<Member> dragged;
  OutlinerTree tree;
};

struct MeasuredSections;

/// A number's text when Shift+Tab gave the keyboard to a field above, which is drawn first.
struct LeftField {
  unsigned id = 0;  ///< ImGui's; 0 for none
  std::string text, from;
};

/// State of panels between frames.
struct PanelState {
  double typed = 0;        ///< value of the number field of the legend being edited
  std::string typed_text;  ///< contents of the text field being edited
  std::string typed_from;  ///< text that the number field held before
  unsigned typing = 0;     ///< ImGui id of the number field being edited, 0 for none
  LeftField left;
  bool field_opening = false;  ///< in this frame a field waits for the keyboard
  std::string typing_row;      ///< mark of the number field that has the keyboard in this frame
  SteadyRows steady;           ///< rows of the properties
  /// Steps of fields of this frame, made when all panels are drawn: until then the rows stand as they stood,
  /// and Tab finds the next one.
  std::vector<std::function<void()>> steps;
  std::string wanted_menu;  ///< the menu that a key opens, in English; empty for none
  bool menu_open = false;   ///< a menu of the bar was drawn last
  enum class MenuLetters { hidden, with_alt, alone };
  MenuLetters menu_letters = MenuLetters::hidden;  ///< way in which keys open menus now, which the bar shows
  std::string wanted_row;                          ///< id of the field or list that a command asked for
  double wanted_until = 0;                         ///< by Editor::now; it is given up then
  std::string pointed_row;                         ///< the one that has a ring
  double pointed_until = 0;                        ///< by Editor::now
  OutlinerState outliner;
  bool history_open = false;
  std::uint64_t history_shown = 0;  ///< serial of the state that the list of steps has scrolled to
  /// The continuity that the status line told last, and what it was found from.
  std::shared_ptr<const ContinuityReport> reached_from;
  ContinuityTolerance reached_tolerance;
  ReachedContinuity reached;
  std::shared_ptr<const MeasuredSections> measured_sections;  ///< sections of the skin that was shown last
};

class ApplicationServices;
class CardFocus;
class CommandServices;

/// Context of panels: what they need from the rest.
struct PanelContext {
  Editor& editor;
  const CommandTable& commands;
  Marks& marks;
  const Metrics& metrics;
  PanelState& state;
  std::vector<Sample>& samples;
  CommandServices& services;
  ApplicationServices& application;
  std::string tool_hint;
  const Language& tr;
  const Offers& offers;
  CardFocus* focus = nullptr;  ///< focus of the page that is being drawn, where keys choose

  /// Runs a command; when it cannot run, its reason becomes a notice.
  void run(std::string_view id);
};

struct PanelRect {
  ImVec2 min, max;
  float width() const { return max.x - min.x; }
  float height() const { return max.y - min.y; }
};

/// Begins a window that fills a rectangle; pair with ImGui::End().
bool begin_panel(const char* name, const PanelRect& rect, ImU32 background, ImVec2 padding,
                 ImGuiWindowFlags extra = 0);

/// Gives the keyboard to the next field, a frame or two from now. Its window is focused first: Dear ImGui
/// 1.90.1 finds no field in the scope of another window.
void focus_next_field();

/// Height that the list of objects wants, of the `available` height of the side.
float objects_height(const PanelContext& context, float available);
float draw_menu_bar(PanelContext& context);  ///< returns its height
/// Width that the column needs for all its buttons to show in this height.
float tool_column_width(const Metrics& metrics, float height);
void draw_tool_column(PanelContext& context, const PanelRect& rect);
void draw_objects(PanelContext& context, const PanelRect& rect);
void draw_properties(PanelContext& context, const PanelRect& rect);
/// Height that the list of steps wants, of the `available` height of the side.
float history_height(const PanelContext& context, float available);
void draw_history(PanelContext& context, const PanelRect& rect);
/// Part of the properties: the numbers of the step just made, where it can still be adjusted.
void draw_last_operation(PanelContext& context);
void draw_status_line(PanelContext& context, const PanelRect& rect);
void draw_notices(PanelContext& context, const PanelRect& viewport);
/// Reason why a key did nothing, beside where the pointer was.
void draw_cursor_note(PanelContext& context);
/// Triangles of the active object within tolerances, and their errors.
void draw_meshing(PanelContext& context, const PanelRect& rect);
/// The step of the guided first model.
void draw_guide(PanelContext& context, const PanelRect& rect);

/// The button that most people want next, in the accent colour; otherwise like `text_button`.
bool main_button(Marks& marks, const std::string& mark, const std::string& text, float width = 0);
/// A place that is pressed like a button, with the ring of the keyboard; the caller draws what it shows.
bool area_button(Marks& marks, const std::string& mark, ImVec2 size);
/// A place that the pointer alone presses or drags: keys go past it.
bool pointer_button(Marks& marks, const std::string& mark, ImVec2 size);
/// Items in this scope are pale and cannot be changed where `disabled` says so, and keys go past them: Tab
/// would count every item.
class Disabled {
 public:
  explicit Disabled(bool disabled);
  ~Disabled();
  Disabled(const Disabled&) = delete;
  Disabled& operator=(const Disabled&) = delete;

 private:
  bool disabled_, looking_;
};
/// Ring round the item that the keyboard is at, as after a key that went there.
void show_keyboard_focus();
/// A small heading; translates it.
void heading(const PanelContext& context, const char* text);
/// A heading that a click folds its rows under or unfolds; translates it. True where they show. Mark:
/// "section.<id>".
bool folding_heading(PanelContext& context, const std::string& id, const char* text,
                     ImGuiTreeNodeFlags extra = 0);
/// A borderless button with an icon and a tooltip, which it translates; `on` tints it.
bool icon_button(const PanelContext& context, const char* icon, const std::string& mark, const char* tooltip,
                 bool on = false, float size = 28);

}  // namespace hariko
