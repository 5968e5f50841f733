#include "tests/core/text/names.h"

#include <gtest/gtest.h>

namespace marey::test {

const std::vector<NamesOfALanguage>& names_of_languages() {
  using enum CharacterSet;
  static const std::vector<NamesOfALanguage> languages = {
      {"Russian", Windows1251, {"Таз", "Поясница", "Грудь", "Шея", "Голова", "Левое плечо", "Левая_рука", "Кисть.Л", "Стопа.П"}},
      {"Russian in capitals", Windows1251, {"ТАЗ", "СПИНА", "ГРУДЬ", "ШЕЯ", "ГОЛОВА", "ПЛЕЧО_Л", "РУКА_Л", "НОГА_П", "СТОПА_П"}},
      {"Russian, one name", Windows1251, {"Hips", "Spine", "Голова", "LeftArm"}},
      {"Ukrainian", Windows1251, {"Таз", "Хребет", "Шия", "Голова", "Ліве плече", "Ліва рука", "Права ступня", "Коліно"}},
      {"German", Windows1252, {"Hüfte", "Wirbelsäule", "Schädel", "linker Fuß", "Größe", "Füße", "Rückenwirbel"}},
      {"German, one name", Windows1252, {"Hips", "Rücken", "LeftArm"}},
      {"French", Windows1252, {"Tête", "Épaule gauche", "Côté", "Poignet", "Épine dorsale", "Avant-bras à droite", "créé"}},
      {"Spanish", Windows1252, {"Cabeza", "Muñeca", "Pie_derecho", "Columna", "Talón", "Pulgar ñandú"}},
      {"Portuguese", Windows1252, {"Mão", "Braço", "Cabeça", "Tórax", "Coração", "Joelho"}},
      {"Swedish", Windows1252, {"Höft", "Ryggrad", "Vänster hand", "Höger fot", "Tå", "Armbåge", "Knä"}},
      {"Chinese", Gbk, {"骨盆", "脊柱", "颈部", "头", "左肩", "左上臂", "左手", "右大腿", "右脚趾", "髋关节"}},
      {"Chinese with ASCII", Gbk, {"Bip01 骨盆", "Bip01 左手", "头_end", "右脚R", "左膝L"}},
      {"Chinese, one name", Gbk, {"Hips", "Spine", "左手"}},
      {"traditional Chinese", Gbk, {"頭", "頸部", "左臂", "脊椎", "右腳", "左鎖骨", "軀幹"}},
      {"Japanese", ShiftJis, {"センター", "上半身", "首", "頭", "左肩", "左ひじ", "左手首", "ボーン", "右足ＩＫ", "右つま先"}},
      {"Japanese kanji", ShiftJis, {"頭", "首", "左肩", "右肩", "左腕", "右腕", "腰", "左足", "右足", "背骨"}},
      {"Japanese in half width", ShiftJis, {"ｾﾝﾀｰ", "ｱﾀﾏ", "ﾋﾀﾞﾘｱｼ", "ﾐｷﾞﾃ", "ｺｼ"}},
  };
  return languages;
}

std::string bytes_in(CharacterSet set, const std::string& utf8) {
  const Result<std::string> bytes = encoded(utf8, set);
  EXPECT_TRUE(bytes) << utf8;
  return bytes ? *bytes : std::string();
}

std::string chain_file(const std::vector<std::string>& names, const std::string& header_line) {
  std::string tree = "HIERARCHY\n";
  std::string indent;
  for (std::size_t i = 0; i < names.size(); ++i) {
    tree.append(indent).append(i == 0 ? "ROOT " : "JOINT ").append(names[i]).append("\n").append(indent).append("{\n");
    indent += "  ";
    tree.append(indent).append("OFFSET 0.00 10.00 0.00\n");
    tree.append(indent).append(i == 0 ? "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
                                      : "CHANNELS 3 Zrotation Xrotation Yrotation\n");
  }
  tree.append(indent).append("End Site\n").append(indent).append("{\n").append(indent).append("  OFFSET 0.00 5.00 0.00\n");
  for (; !indent.empty(); indent.resize(indent.size() - 2)) tree.append(indent).append("}\n");
  tree += "}\n" + header_line + "MOTION\nFrames: 2\nFrame Time: 0.04\n";
  for (int frame = 0; frame < 2; ++frame) {
    for (std::size_t i = 0; i < 3 * names.size() + 3; ++i) tree += i == 0 ? "1.50" : " 0.00";
    tree += "\n";
  }
  return tree;
}

}  // namespace marey::test
