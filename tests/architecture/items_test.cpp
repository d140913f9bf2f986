// Items of Dear ImGui, such as buttons, lists and fields, are called in ui/widgets only, which names them for
// the tests of windows. Other folders call what it offers; they may lay out, draw and ask about the last
// item.

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "tests/support/places.hpp"

namespace {

namespace fs = std::filesystem;

const std::set<std::string>& item_names() {
  static const std::set<std::string> names = {
      // texts
      "Text", "TextV", "TextUnformatted", "TextColored", "TextColoredV", "TextDisabled", "TextDisabledV",
      "TextWrapped", "TextWrappedV", "LabelText", "LabelTextV", "BulletText", "BulletTextV", "Bullet",
      "SeparatorText", "SetTooltip", "SetTooltipV", "BeginTooltip", "EndTooltip", "SetItemTooltip",
      "SetItemTooltipV", "BeginItemTooltip",
      // buttons
      "Button", "SmallButton", "InvisibleButton", "ArrowButton", "ImageButton", "Image", "Checkbox",
      "CheckboxFlags", "RadioButton", "ProgressBar",
      // lists
      "BeginCombo", "EndCombo", "Combo", "BeginListBox", "EndListBox", "ListBox", "Selectable",
      // numbers, colours and texts that change
      "DragFloat", "DragFloat2", "DragFloat3", "DragFloat4", "DragFloatRange2", "DragInt", "DragInt2",
      "DragInt3", "DragInt4", "DragIntRange2", "DragScalar", "DragScalarN", "SliderFloat", "SliderFloat2",
      "SliderFloat3", "SliderFloat4", "SliderAngle", "SliderInt", "SliderInt2", "SliderInt3", "SliderInt4",
      "SliderScalar", "SliderScalarN", "VSliderFloat", "VSliderInt", "VSliderScalar", "InputText",
      "InputTextMultiline", "InputTextWithHint", "InputFloat", "InputFloat2", "InputFloat3", "InputFloat4",
      "InputInt", "InputInt2", "InputInt3", "InputInt4", "InputDouble", "InputScalar", "InputScalarN",
      "ColorEdit3", "ColorEdit4", "ColorPicker3", "ColorPicker4", "ColorButton", "PlotLines", "PlotHistogram",
      "Value",
      // trees and tables
      "TreeNode", "TreeNodeV", "TreeNodeEx", "TreeNodeExV", "TreePush", "TreePop", "CollapsingHeader",
      "BeginTable", "EndTable", "TableNextRow", "TableNextColumn", "TableSetColumnIndex", "TableSetupColumn",
      "TableHeadersRow", "TableHeader", "BeginTabBar", "EndTabBar", "BeginTabItem", "EndTabItem",
      "TabItemButton",
      // menus and what else opens over a window
      "BeginMenu", "EndMenu", "MenuItem", "BeginPopup", "BeginPopupModal", "BeginPopupContextItem",
      "BeginPopupContextWindow", "BeginPopupContextVoid", "EndPopup"};
  return names;
}

/// Items that a line of code calls. Comments count as code: none needs such a name.
std::vector<std::string> items_in(const std::string& line) {
  static const std::string call = "ImGui::";
  std::vector<std::string> out;
  for (std::size_t at = line.find(call); at != std::string::npos; at = line.find(call, at)) {
    at += call.size();
    std::size_t end = at;
    while (end < line.size() && (std::isalnum(static_cast<unsigned char>(line[end])) != 0)) ++end;
    const std::string name = line.substr(at, end - at);
    if (item_names().contains(name)) out.push_back(name);
  }
  return out;
}

/// Names of textures become ImGui's in one function.
bool names_texture(const std::string& line) {
  return line.find("ImTextureID") != std::string::npos;
}

/// Keys are told by `KeyChord`, or by what a widget makes of them.
bool names_key(const std::string& line) {
  return line.find("ImGuiKey_") != std::string::npos;
}

TEST(Items, AreCalledInWidgetsOnly) {
  const fs::path top = hariko::test::source_folder();
  std::size_t files = 0, in_widgets = 0;
  for (const char* layer : {"ui", "app"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top / layer)) {
      if (entry.path().extension() != ".hpp" && entry.path().extension() != ".cpp") continue;
      ++files;
      const std::string file = fs::relative(entry.path(), top).generic_string();
      const bool widgets = file.starts_with("ui/widgets/");
      std::ifstream stream(entry.path());
      std::string line;
      for (int number = 1; std::getline(stream, line); ++number) {
        EXPECT_TRUE(file == "ui/base/texture.hpp" || !names_texture(line))
            << file << ":" << number << ": textures of ImGui stay in ui/base/texture.hpp";
        const std::vector<std::string> items = items_in(line);
        if (widgets) {
          in_widgets += items.size();
          continue;
        }
        for (const std::string& item : items)
          ADD_FAILURE() << file << ":" << number << ": ImGui::" << item << " is called in ui/widgets only";
        EXPECT_FALSE(names_key(line)) << file << ":" << number << ": keys of ImGui stay in ui/widgets";
      }
    }
  EXPECT_GT(files, 100U) << "the sources were not found";
  EXPECT_GT(in_widgets, 20U) << "items are called in another way now";
}

TEST(Items, CallsAreFound) {
  EXPECT_EQ(items_in("  if (ImGui::Button(\"x\") && ImGui::SmallButton(\"y\")) run();"),
            (std::vector<std::string>{"Button", "SmallButton"}));
  EXPECT_EQ(items_in("return ImGui::TextUnformatted(text);"), std::vector<std::string>{"TextUnformatted"});
  EXPECT_TRUE(items_in("ImGui::SameLine(); ImGui::PushID(3); ImGui::Dummy({0, 4});").empty());
  EXPECT_TRUE(items_in("ImGui::IsItemHovered() && ImGui::GetTextLineHeight() > ImGui::").empty());
  EXPECT_TRUE(names_key("data->EventKey == ImGuiKey_UpArrow"));
  EXPECT_FALSE(names_key("ImGuiKeyData"));
  EXPECT_TRUE(names_texture("ImTextureID picture = nullptr;"));
}

}  // namespace
